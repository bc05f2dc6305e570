#include "ui/view/ground_grid.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

#include "ui/look/units.h"

namespace blossom::ui {

namespace {

constexpr int majorEvery = 5;
constexpr int halfCount = 60;      // lines on each side of the middle
constexpr int piecesPerLine = 24;  // a fade needs vertices along the line

double niceSpacing(double wanted) {
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (wanted <= step * power) return step * power;
  return 10 * power;
}

class LineWriter {
 public:
  LineWriter(const Vec2& center, double reach) : center_(center), reach_(reach) {
    points_->SetDataTypeToDouble();
    colors_->SetNumberOfComponents(4);
  }

  void add(const Vec2& from, const Vec2& to, const Color& color, double alpha) {
    cells_->InsertNextCell(piecesPerLine + 1);
    for (int i = 0; i <= piecesPerLine; ++i) {
      const Vec2 p = from + (to - from) * (static_cast<double>(i) / piecesPerLine);
      const double far = (p - center_).norm() / reach_;
      const double fade = std::clamp(1.15 - 1.2 * far * far, 0.0, 1.0);
      cells_->InsertCellPoint(points_->InsertNextPoint(p.x(), p.y(), 0));
      const auto byte = [](double v) { return static_cast<unsigned char>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
      const unsigned char rgba[4] = {byte(color.red), byte(color.green), byte(color.blue), byte(alpha * fade)};
      colors_->InsertNextTypedTuple(rgba);
    }
  }

  void store(vtkPolyData& data) {
    data.SetPoints(points_);
    data.SetLines(cells_);
    data.GetPointData()->SetScalars(colors_);
    data.Modified();
  }

 private:
  Vec2 center_;
  double reach_;
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkCellArray> cells_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

}  // namespace

GroundGrid::GroundGrid() : lines_(vtkSmartPointer<vtkPolyData>::New()), actor_(vtkSmartPointer<vtkActor>::New()) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(lines_);
  mapper->SetScalarModeToUsePointData();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(2, 4);  // what lies on the ground is in front of the grid
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetLighting(false);
  actor_->ForceOpaqueOn();  // blended in place; a pass for translucent things would cost every frame
  actor_->PickableOff();
  actor_->UseBoundsOff();
}

bool GroundGrid::follow(const Vec3& target, double millimetresPerPixel, double viewHeight, const Look& look) {
  const double spacing = niceSpacing(millimetresPerPixel * 16 / lengthUnit().millimetres) * lengthUnit().millimetres;
  const double major = spacing * majorEvery;
  const Vec2 center(std::round(target.x() / major) * major, std::round(target.y() / major) * major);
  const double reach = std::min(spacing * halfCount, millimetresPerPixel * viewHeight * 2.2);
  const bool same =
      spacing == spacing_ && center == center_ && drawnIn_ == look.grid && reach < reach_ * 1.3 && reach > reach_ / 1.3;
  if (same) return false;
  spacing_ = spacing;
  center_ = center;
  reach_ = reach;
  drawnIn_ = look.grid;
  rebuild(look);
  return true;
}

void GroundGrid::rebuild(const Look& look) {
  LineWriter writer(center_, reach_);
  const int count = static_cast<int>(std::ceil(reach_ / spacing_));
  const auto line = [&](int axis, double at, const Color& color, double alpha) {
    Vec2 from = center_, to = center_;
    from[axis] -= reach_;
    to[axis] += reach_;
    from[1 - axis] = to[1 - axis] = at;
    writer.add(from, to, color, alpha);
  };
  for (int axis = 0; axis < 2; ++axis)
    for (int i = -count; i <= count; ++i) {
      const double at = center_[1 - axis] + i * spacing_;
      const auto index = std::llround(at / spacing_);
      if (index == 0) continue;  // an axis stands there
      line(axis, at, look.grid, index % majorEvery == 0 ? 0.26 : 0.10);
    }
  line(0, 0, {0.86, 0.36, 0.36}, 0.55);
  line(1, 0, {0.42, 0.70, 0.42}, 0.55);
  writer.store(*lines_);
}

}  // namespace blossom::ui
