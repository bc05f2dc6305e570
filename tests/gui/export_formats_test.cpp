#include "ui/files/export_dialog.h"

#include <algorithm>

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
};

BLOSSOM_WINDOW_TEST(ExportFormatsTest)
#include "export_formats_test.moc"
