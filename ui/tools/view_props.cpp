#include "ui/tools/view_props.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>
#include <vtkViewport.h>

#include <QApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace blossom::ui {

namespace {

// A depth offset beyond all that occurs brings lines and points before everything.
constexpr double inFront = -66000;

vtkSmartPointer<vtkActor> actorOf(vtkPolyData* data, const Color& color) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(0, inFront);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(inFront);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.red, color.green, color.blue);
  actor->GetProperty()->SetLighting(false);
  actor->PickableOff();
  return actor;
}

QImage drawnLabel(const QString& text, const LabelLook& look) {
  QFont font = QApplication::font();
  font.setPixelSize(12);
  font.setWeight(QFont::DemiBold);
  constexpr double widest = 420;  // logical pixels; longer texts have several lines
  const QRectF room = QFontMetricsF(font).boundingRect(QRectF(0, 0, widest, 0), Qt::AlignCenter | Qt::TextWordWrap, text);
  const QSizeF size(std::ceil(room.width()) + 14, std::ceil(room.height()) + 6);
  QImage image((size * look.pixelRatio).toSize(), QImage::Format_RGBA8888);
  image.setDevicePixelRatio(look.pixelRatio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look.border, 1));
  painter.setBrush(look.card);
  const QRectF card(QPointF(0, 0), size);
  painter.drawRoundedRect(card.adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
  painter.setFont(font);
  painter.setPen(look.text);
  painter.drawText(card, Qt::AlignCenter | Qt::TextWordWrap, text);
  return image;
}

vtkSmartPointer<vtkTexture> textureOf(const QImage& picture) {
  const QImage image = picture.convertToFormat(QImage::Format_RGBA8888).mirrored();  // VTK's first row is the lowest
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(image.width(), image.height(), 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  for (int y = 0; y < image.height(); ++y)
    std::memcpy(data->GetScalarPointer(0, y, 0), image.constScanLine(y), static_cast<std::size_t>(image.width()) * 4);
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(data);
  texture->InterpolateOff();
  texture->RepeatOff();
  return texture;
}

// A rectangle of pixels whose lower edge has its middle at the place where it is anchored, or shifted from there.
vtkSmartPointer<vtkPolyData> rectangle(const QSize& size, const QPointF& shift) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto places = vtkSmartPointer<vtkFloatArray>::New();
  places->SetNumberOfComponents(2);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->InsertNextCell(4);
  const int width = size.width(), height = size.height();
  const int left = static_cast<int>(std::lround(shift.x())) - width / 2, low = static_cast<int>(std::lround(shift.y()));
  const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& corner : corners) {
    const int x = corner[0] > 0 ? left + width : left, y = corner[1] > 0 ? low + height : low;
    cells->InsertCellPoint(points->InsertNextPoint(x, y, 0));
    places->InsertNextTuple(corner);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetTCoords(places);
  return data;
}

/// What becomes of a picture that the border of the view would cut.
enum class InView { AsItLies, WithItsPosition, Always };

/// A picture over all else, the lines and points that are brought before everything among it: the depth that these have is
/// beyond that of the foreground where a driver does not limit it.
class PictureActor : public vtkTexturedActor2D {
 public:
  static PictureActor* New();
  PictureActor(const PictureActor&) = delete;
  PictureActor& operator=(const PictureActor&) = delete;

  void keepInView(InView how) { inView_ = how; }

  int RenderOverlay(vtkViewport* viewport) override {
    const std::array<double, 2> shift = wayIntoView(viewport);
    if (shift[0] == 0 && shift[1] == 0) return renderOverAll(viewport);
    vtkCoordinate& position = *GetPositionCoordinate();
    const std::array<int, 2> seen = seenAt(viewport);
    const std::array<double, 3> world = {position.GetValue()[0], position.GetValue()[1], position.GetValue()[2]};
    position.SetCoordinateSystemToViewport();
    position.SetValue(seen[0] + shift[0], seen[1] + shift[1], 0);
    const int rendered = renderOverAll(viewport);
    position.SetCoordinateSystemToWorld();
    position.SetValue(world[0], world[1], world[2]);
    return rendered;
  }

 protected:
  PictureActor() = default;
  ~PictureActor() override = default;

 private:
  std::array<int, 2> seenAt(vtkViewport* viewport) {
    const int* const at = GetPositionCoordinate()->GetComputedViewportValue(viewport);
    return {at[0], at[1]};
  }

  /// In pixels of the frame, by which all of the picture is seen.
  std::array<double, 2> wayIntoView(vtkViewport* viewport) {
    if (inView_ == InView::AsItLies) return {0, 0};
    constexpr int gap = 4;
    const std::array<int, 2> at = seenAt(viewport);
    const int* const size = viewport->GetSize();
    const double* const bounds = pictureBounds();
    std::array<double, 2> way{0, 0};
    for (std::size_t k = 0; bounds && k < 2; ++k) {
      if (inView_ == InView::WithItsPosition && (at.at(k) < 0 || at.at(k) > size[k])) return {0, 0};
      const double low = at.at(k) + bounds[2 * k], high = at.at(k) + bounds[2 * k + 1];
      if (high - low + 2 * gap > size[k]) continue;
      way.at(k) = std::max(gap - low, 0.0) + std::min(size[k] - gap - high, 0.0);
    }
    return way;
  }

  const double* pictureBounds() {
    auto* const flat = vtkPolyDataMapper2D::SafeDownCast(GetMapper());
    return flat && flat->GetInput() ? flat->GetInput()->GetBounds() : nullptr;
  }

  int renderOverAll(vtkViewport* viewport) {
    auto* const window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow());
    if (!window) return vtkTexturedActor2D::RenderOverlay(viewport);
    constexpr unsigned int depthTest = 0x0B71;  // GL_DEPTH_TEST
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable asBefore(state, depthTest);
    state->vtkglDisable(depthTest);
    return vtkTexturedActor2D::RenderOverlay(viewport);
  }

  InView inView_ = InView::AsItLies;
};
vtkStandardNewMacro(PictureActor);

PropPtr flatProp(const QImage& image, const Vec3& at, const QPointF& shift, InView how) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper2D>::New();
  mapper->SetInputData(rectangle(image.size(), shift));
  auto actor = vtkSmartPointer<PictureActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(textureOf(image));
  actor->keepInView(how);
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->GetPositionCoordinate()->SetValue(at.x(), at.y(), at.z());
  actor->PickableOff();
  return actor;
}

}  // namespace

PropPtr linesProp(const std::vector<std::vector<Vec3>>& lines, const Color& color, double width) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& line : lines) {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vec3& p : line) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  auto actor = actorOf(data, color);
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  return actor;
}

PropPtr pointsProp(const std::vector<Vec3>& all, const Color& color, double size) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Vec3& p : all) {
    const vtkIdType id = points->InsertNextPoint(p.data());
    cells->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  auto actor = actorOf(data, color);
  actor->GetProperty()->SetRenderPointsAsSpheres(true);
  actor->GetProperty()->SetPointSize(static_cast<float>(size));
  return actor;
}

PropPtr trianglesProp(const std::vector<std::array<Vec3, 3>>& triangles, const Color& color, double opacity) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& triangle : triangles) {
    cells->InsertNextCell(3);
    for (const Vec3& p : triangle) cells->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  auto actor = actorOf(data, color);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetLighting(opacity == 1);  // solid things show their form
  return actor;
}

namespace {

vtkInformationIntegerKey* cutKey() {
  static vtkInformationIntegerKey* const key = vtkInformationIntegerKey::MakeKey("CUT_BY_SECTION", "blossom");
  return key;
}

}  // namespace

void cutBySection(vtkProp& prop) {
  if (!prop.GetPropertyKeys()) prop.SetPropertyKeys(vtkSmartPointer<vtkInformation>::New());
  prop.GetPropertyKeys()->Set(cutKey(), 1);
}

bool isCutBySection(vtkProp& prop) { return prop.GetPropertyKeys() && prop.GetPropertyKeys()->Has(cutKey()); }

PropPtr labelProp(const QString& text, const Vec3& at, const LabelLook& look) {
  // Above the place, so that what it names stays in sight.
  return flatProp(drawnLabel(text, look), at, (QPointF(0, labelGap) + look.shift) * look.pixelRatio,
                  look.follow ? InView::Always : InView::WithItsPosition);
}

PropPtr pictureProp(const QImage& image, const Vec3& at) {
  return flatProp(image, at, QPointF(0, -image.height() / 2.0), InView::AsItLies);
}

QColor qtColor(const Color& color, double opacity) {
  return QColor::fromRgbF(static_cast<float>(color.red), static_cast<float>(color.green), static_cast<float>(color.blue),
                          static_cast<float>(opacity));
}

LabelLook labelLook(const Look& look, const Color& color, double pixelRatio) {
  return {qtColor(color), qtColor(look.backgroundBottom, 0.85), qtColor(color, 0.5), pixelRatio};
}

std::optional<Vec2> inGround(const Ray& ray) {
  if (std::abs(ray.direction.z()) < 1e-9) return std::nullopt;
  const double along = -ray.origin.z() / ray.direction.z();
  if (along < 0) return std::nullopt;
  return Vec2((ray.origin + along * ray.direction).head<2>());
}

}  // namespace blossom::ui
