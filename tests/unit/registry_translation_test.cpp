// The texts of the registry stand in no tr(): what lupdate is for others, this test is for them. It prints every text that
// lacks a translation as a message to be filled in, and names those that nobody says any more.
#include <QTranslator>
#include <map>
#include <set>

#include "app/app.h"
#include "support/support.h"
#include "support/translations.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// By text: where it is said first.
using Texts = std::map<QString, QString>;

class Collector {
 public:
  explicit Collector(const App& app) {
    for (const LoadedPlugin& plugin : app.plugins) add(plugin.manifest.title, plugin.manifest.id);
    for (const auto& type : app.registry->types()) addType(*type);
    for (const Format& format : app.formats->formats()) {
      addSpecs(format.readOptions, format.id);
      addSpecs(format.writeOptions, format.id);
    }
  }
  [[nodiscard]] const Texts& texts() const { return texts_; }

 private:
  void add(const std::string& text, const std::string& where) {
    if (!text.empty()) texts_.emplace(QString::fromStdString(text), QString::fromStdString(where));
  }
  void addType(const FeatureType& type) {
    add(type.title, type.id);
    add(type.summary, type.id);
    for (const InputSpec& input : type.inputs)
      for (const std::string& text : {input.name, input.help, input.asks}) add(text, type.id);
    addSpecs(type.parameters, type.id);
  }
  void addSpecs(const std::vector<ParameterSpec>& specs, const std::string& where) {
    for (const ParameterSpec& spec : specs) {
      for (const std::string& text : {label(spec), spec.help, spec.noneMeans}) add(text, where);
      for (const std::string& choice : spec.choices) add(choice, where);
      addSpecs(spec.fields, where);
    }
  }
  Texts texts_;
};

/// Texts that the window has translated as those of the registry, without being in it.
const std::set<QString>& besides() {
  static const std::set<QString> texts{QStringLiteral("Smooth"),  // a feature of the tool that pulls cages
                                       QStringLiteral("face"), QStringLiteral("edge"), QStringLiteral("vertex"),
                                       QStringLiteral("part")};
  return texts;
}

}  // namespace

class RegistryTranslationTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void everyTextIsTranslated();
  void nothingIsTranslatedThatIsGone();
  void everyTranslationIsFinished();
  void theWindowFindsThem();

 private:
  Texts texts_;
  std::vector<TranslatedMessage> messages_;
};

void RegistryTranslationTest::initTestCase() {
  const App app = loadApp();
  for (const LoadedPlugin& plugin : app.plugins) QVERIFY2(plugin.problem.empty(), plugin.problem.c_str());
  texts_ = Collector(app).texts();
  for (TranslatedMessage& each : messagesOf(translationFile(QStringLiteral("features_de"))))
    if (each.context == QLatin1String("Registry")) messages_.push_back(std::move(each));
  QVERIFY(texts_.size() > 400);
}

void RegistryTranslationTest::everyTextIsTranslated() {
  std::set<QString> known;
  for (const TranslatedMessage& each : messages_) known.insert(each.source);
  QString missing;
  int count = 0;
  for (const auto& [text, where] : texts_) {
    if (known.contains(text)) continue;
    ++count;
    missing += QStringLiteral(
                   "    <message>\n        <!-- %1 -->\n        <source>%2</source>\n"
                   "        <translation></translation>\n    </message>\n")
                   .arg(where, text.toHtmlEscaped());
  }
  QVERIFY2(missing.isEmpty(), qPrintable(QStringLiteral("%1 texts are missing in the context Registry of "
                                                        "resources/translations/features_de.ts:\n")
                                             .arg(count) +
                                         missing));
}

void RegistryTranslationTest::nothingIsTranslatedThatIsGone() {
  QStringList gone;
  for (const TranslatedMessage& each : messages_)
    if (!texts_.contains(each.source) && !besides().contains(each.source)) gone << each.source;
  QVERIFY2(gone.isEmpty(), qPrintable(gone.join(u'\n')));
}

void RegistryTranslationTest::everyTranslationIsFinished() {
  std::set<QString> seen;
  for (const TranslatedMessage& each : messages_) {
    QVERIFY2(each.finished && !each.translation.isEmpty(), qPrintable(each.source));
    QVERIFY2(seen.insert(each.source).second, qPrintable(each.source));
    QCOMPARE(each.translation.endsWith(u'.'), each.source.endsWith(u'.'));
  }
}

void RegistryTranslationTest::theWindowFindsThem() {
  QTranslator translator;
  QVERIFY(translator.load(QString::fromStdString((buildFolder() / "share/blossom/translations/features_de.qm").string())));
  for (const TranslatedMessage& each : messages_)
    QCOMPARE(translator.translate("Registry", each.source.toUtf8().constData()), each.translation);
}

BLOSSOM_TEST(RegistryTranslationTest)
#include "registry_translation_test.moc"
