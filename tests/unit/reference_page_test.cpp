#include "app/reference_page.h"
#include "app/app.h"
#include "support/support.h"

using namespace blossom;

namespace {

struct P {
  double width = 10;
  bool closed = false;
  std::string how = "round|square";
};

FeatureType declared() {
  return feature<P>("example.pipe_fitting", "Fitting <T>", "A part with * and | in its text.")
      .command("fitting")
      .produces({ShapeKind::Brep, ShapeKind::Mesh})
      .input({"base", "What it sits on.", {ShapeKind::Brep, ShapeKind::Mesh}})
      .input({"others", "Cut off.", {}, 0, anyNumber})
      .parameter("width", &P::width, onlyFor(positiveLength(), "how", {"flat"}), "How wide.")
      .parameter("closed", &P::closed, flag(), "Whether it is shut.")
      .parameter("how", &P::how, choice({"round|square", "flat"}), "In which way.")
      .example("blossom fitting base.step -o out.step")
      .evaluate([](const P&, const Inputs&, const Progress&) { return Evaluated{}; });
}

std::vector<QString> rowsOf(const QString& page) {
  std::vector<QString> rows;
  for (const QString& line : page.split(u'\n'))
    if (line.startsWith(u'|')) rows.push_back(line);
  return rows;
}

// Bars that end a cell: those that are not escaped.
qsizetype cells(const QString& row) { return QString(row).remove(QStringLiteral("\\|")).count(u'|') - 1; }

}  // namespace

class ReferencePageTest : public QObject {
  Q_OBJECT
 private slots:
  void everythingDeclaredIsThere();
  void tablesHoldTogetherWhateverTheTextsSay();
  void everyFeatureTypeHasAPage();
};

void ReferencePageTest::everythingDeclaredIsThere() {
  const QString page = QString::fromStdString(referencePage(declared()));
  for (const char* part : {"# Fitting", "`fitting`", "`example.pipe_fitting`", "base", "others", "0 or more", "any shape",
                           "`width`", "A sequence is taken frame by frame", "above 0 mm; only if how is flat", "`10 mm`",
                           "How wide.", "`closed`", "off", "Gives solid or faces or mesh.",
                           "blossom fitting base [others others..] -o FILE", "blossom fitting base.step -o out.step"})
    QVERIFY2(page.contains(QLatin1String(part)), part);
}

void ReferencePageTest::tablesHoldTogetherWhateverTheTextsSay() {
  const QString page = QString::fromStdString(referencePage(declared()));
  const auto rows = rowsOf(page);
  QCOMPARE(rows.size(), std::size_t{2 + 2 + 2 + 3});
  for (const QString& row : rows) QVERIFY2(cells(row) == 4, qPrintable(row));
  QVERIFY(page.contains(QLatin1String("\\<T\\>")));
}

void ReferencePageTest::everyFeatureTypeHasAPage() {
  const App app = loadApp();
  QVERIFY(app.registry->types().size() > 2);
  for (const auto& type : app.registry->types()) {
    const QString page = QString::fromStdString(referencePage(*type));
    QVERIFY(page.startsWith(QLatin1String("# ")));
    for (const ParameterSpec& spec : type->parameters)
      QVERIFY2(page.contains(QStringLiteral("| `%1`").arg(QString::fromStdString(spec.name))), spec.name.c_str());
    for (const QString& row : rowsOf(page)) QVERIFY2(cells(row) == 4, qPrintable(row));
  }
}

BLOSSOM_TEST(ReferencePageTest)
#include "reference_page_test.moc"
