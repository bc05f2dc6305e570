#include "ui/files/export_dialog.h"

#include <QComboBox>
#include <QPushButton>
#include <QScreen>
#include <algorithm>

#include "exchange/formats.h"
#include "support/modeling.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

namespace {

bool isOffered(const char* id, const ExportScope& scope) {
  const std::vector<const Format*> fitting = formatsFor(*theApp().formats, scope);
  return std::any_of(fitting.begin(), fitting.end(), [&](const Format* format) { return format->id == id; });
}

ExportScope sequenceOf(std::vector<ShapeKind> frameKinds) {
  ExportScope scope;
  scope.kind = ShapeKind::Sequence;
  scope.frameKinds = std::move(frameKinds);
  return scope;
}

}  // namespace

/// The formats that the export dialog offers.
class ExportFormatsTest : public QObject {
  Q_OBJECT

 private slots:
  void aFormatOfASequenceStoresItsFrames() {
    QVERIFY(isOffered("dxf", sequenceOf({ShapeKind::Region})));
    QVERIFY(!isOffered("dxf", sequenceOf({ShapeKind::Mesh})));
    QVERIFY(isOffered("stl", sequenceOf({ShapeKind::Mesh})));
  }

  /// A difference that keeps room without width is a region in one frame and a drawing in the next.
  void framesOfSeveralKindsAreStoredByWhatStoresEach() {
    QVERIFY(isOffered("dxf", sequenceOf({ShapeKind::Curves, ShapeKind::Region})));
    QVERIFY(!isOffered("dxf", sequenceOf({ShapeKind::Region, ShapeKind::Mesh})));
  }

  /// However many options a format has, on however small a screen.
  void theButtonsStayInReach() {
    FormatRegistry many = standardFormats();
    Format format;
    format.id = format.title = "wordy";
    format.extensions = {"wordy"};
    format.writes = {ShapeKind::Region};
    format.write = [](const Shape&, const std::filesystem::path&, const Value&, const Progress&) {};
    for (int k = 0; k < 60; ++k) {
      ParameterSpec option = length();
      option.name = "option-" + std::to_string(k);
      option.help = "One of many.";
      option.fallback = 1.0;
      format.writeOptions.push_back(option);
    }
    many.add(format);
    ExportDialog dialog(many, {{QStringLiteral("It"), {"a"}, ShapeKind::Region}});
    dialog.choose(QStringLiteral("wordy"));
    dialog.show();
    QTRY_VERIFY(dialog.height() <= dialog.screen()->availableSize().height());
    for (const QPushButton* button : dialog.findChildren<QPushButton*>())
      QVERIFY(dialog.rect().contains(QRect(button->mapTo(&dialog, QPoint(0, 0)), button->size())));
    QTRY_VERIFY(dialog.height() > dialog.screen()->availableSize().height() / 2);  // as high as it may be
  }

  void tabReachesTheOptionsBeforeTheButtons() {
    ExportDialog dialog(*theApp().formats, {{QStringLiteral("It"), {"a"}, ShapeKind::Region}});
    for (const char* format : {"svg", "dxf", "svg"}) dialog.choose(QLatin1String(format));
    dialog.show();
    dialog.findChildren<QComboBox*>().front()->setFocus();
    const auto* options = dialog.findChild<QWidget*>(QStringLiteral("exportOptions"));
    int ofOptions = 0;
    for (int k = 0; k < 40 && !qobject_cast<QPushButton*>(dialog.focusWidget()); ++k) {
      QTest::keyClick(dialog.focusWidget(), Qt::Key_Tab);
      ofOptions += options->isAncestorOf(dialog.focusWidget());
    }
    QVERIFY(ofOptions > 0);
    auto* first = qobject_cast<QPushButton*>(dialog.focusWidget());
    QVERIFY(first && first->isDefault());
    QTest::keyClick(first, Qt::Key_Tab);
    QVERIFY(qobject_cast<QPushButton*>(dialog.focusWidget()) != nullptr);
  }
};

BLOSSOM_WINDOW_TEST(ExportFormatsTest)
#include "export_formats_test.moc"
