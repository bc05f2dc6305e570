#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

/// A drawing is shown in the colours of its file, until a colour has something else to tell.
class DrawingColorsTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }

  void selectedItLosesThemAndGetsThemBack() {
    const QString file = folder_.filePath(QStringLiteral("two_lines.svg"));
    QFile out(file);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(
        "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100' fill='none'>"
        "<path stroke='#8000ff' d='M10 10L90 10L90 50'/><path stroke='#ff00ff' d='M10 90L90 90L10 60'/></svg>");
    out.close();
    openAndWait(file);
    QVERIFY(window_->session().document().features().size() == 1);
    const auto seen = [this](const QColor& color) { return colored(canvas(), color); };
    const QColor violet(128, 0, 255), magenta(255, 0, 255);
    window_->tree().select({});
    QTRY_VERIFY(seen(violet) > 1e-4 && seen(magenta) > 1e-4);
    window_->tree().select(last());
    QTRY_VERIFY(seen(violet) < 1e-5 && seen(magenta) < 1e-5);
    window_->tree().select({});
    QTRY_VERIFY(seen(violet) > 1e-4 && seen(magenta) > 1e-4);
  }
};

BLOSSOM_WINDOW_TEST(DrawingColorsTest)
#include "drawing_colors_test.moc"
