// The card of the factors tool: what it shows, and what comes from it.
#include <vtkProp.h>

#include <Eigen/Geometry>
#include <QPointer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/angle.h"
#include "core/error.h"
#include "kernel/grid/factor_comb.h"
#include "manipulators/factors/axis_colors.h"
#include "manipulators/factors/comb_plot.h"
#include "manipulators/factors/factor_amounts.h"
#include "manipulators/factors/factors_panel.h"
#include "manipulators/factors/factors_tool.h"
#include "manipulators/factors/turn_ball.h"
#include "type_ids.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/look/units.h"

namespace blossom::sweep {

namespace {

constexpr std::size_t plotSamples = 161;
constexpr int weightField = FactorsPanel::fieldCount - 1;

ParameterSpec specOfField(Factor factor, int field) {
  ParameterSpec spec = factor == Factor::Trajectory && field < weightField     ? length()
                       : factor == Factor::Orientation && field == weightField ? angle()
                                                                               : number();
  spec.name = "number";
  return spec;
}

/// A text for the values of all chosen poles; none where they differ.
QString common(const ParameterSpec& spec, const std::vector<double>& values, const LengthUnit& unit) {
  if (values.empty()) return {};
  constexpr double alike = 1e-12;
  for (const double value : values)
    if (std::abs(value - values.front()) > alike * (1 + std::abs(value))) return {};
  // As many digits as the field has room for; what is not typed anew keeps all it has.
  constexpr int digits = 6;
  const double shown = QString::number(values.front(), 'g', digits).toDouble();
  return ui::qt(formatText(spec, Value(shown), unit));
}

/// The size of each pole as a share of the largest.
std::vector<double> signSizes(const Motion& motion, const FactorLayout& layout) {
  std::vector<double> sizes;
  double most = 0;
  for (std::size_t i = 0; i < layout.rows(); ++i)
    for (std::size_t j = 0; j < layout.columns(); ++j) {
      const PoleValue value = poleValue(motion, layout.factor, {i, j});
      sizes.push_back(layout.factor == Factor::Scaling ? value.vector.norm() : value.weight);
      most = std::max(most, sizes.back());
    }
  for (double& size : sizes) size = most > 0 ? size / most : 0;
  return sizes;
}

std::vector<double> signDirections(const Motion& motion, const FactorLayout& layout) {
  std::vector<double> directions;
  if (layout.factor != Factor::Orientation) return directions;
  for (std::size_t i = 0; i < layout.rows(); ++i)
    for (std::size_t j = 0; j < layout.columns(); ++j) directions.push_back(poleAngle(motion, {i, j}));
  return directions;
}

/// Teeth down to zero. @param nothing  lengths below that come from rounding
CombCurve barCurve(const std::vector<double>& at, const std::vector<Vec3>& vectors, double nothing, double unit) {
  CombCurve curve{ui::theme().color("control"), {}, {}};
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double length = vectors[k].norm();
    curve.points.emplace_back(at[k], length < nothing ? 0 : unit * length);
  }
  return curve;
}

/// A curvature that nobody could tell from straightness over the length of the trajectory, 1/mm.
double hardlyBent(const Motion& motion, const FactorLayout& layout) {
  constexpr double hardly = 1e-9;
  double size = 0;
  const Vec3 first = poleValue(motion, Factor::Trajectory, {0, 0}).vector;
  for (std::size_t j = 0; j < layout.columns(); ++j)
    size = std::max(size, (poleValue(motion, Factor::Trajectory, {0, j}).vector - first).norm());
  return size > 0 ? hardly / size : 0;
}

std::vector<CombCurve> scalingCurves(const ScalingComb& comb) {
  std::vector<CombCurve> curves;
  for (int axis = 0; axis < 3; ++axis) {
    CombCurve curve{axisColor(axis), {}, {}};
    for (std::size_t k = 0; k < comb.at.size(); ++k) {
      curve.points.emplace_back(comb.at[k], comb.factors[k][axis]);
      curve.teeth.push_back(comb.curvature[k][axis]);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

void FactorsTool::makePanel() {
  QWidget* const view = host().viewWidget();
  if (!view) return;
  panel_ = new FactorsPanel(view);
  panel_->setFactor(factor_);
  connectPanel(*panel_);
  panel_->QWidget::show();
}

void FactorsTool::connectPanel(FactorsPanel& panel) {
  // Later: the card goes with the tool, and its button is on the stack.
  connect(&panel, &FactorsPanel::closeWanted, this, &FactorsTool::close, Qt::QueuedConnection);
  connect(&panel, &FactorsPanel::factorChosen, this, &FactorsTool::chooseFactor);
  connect(&panel, &FactorsPanel::typed, this, &FactorsTool::type);
  connect(&panel, &FactorsPanel::turnWanted, this, &FactorsTool::turn);
  connect(&panel, &FactorsPanel::displayChosen, this, [this] {
    fillPlot();
    drawMotion();
    emit changed();
  });
  const FactorNet& net = panel.net();
  connect(&net, &FactorNet::chosenChanged, this, [this] {
    chosen_ = panel_->net().chosen();
    panel_->forgive();
    fillPanel();
    emit changed();
  });
  connect(&net, &FactorNet::dragged, this, &FactorsTool::dragNet);
  connect(&net, &FactorNet::knotWanted, this, &FactorsTool::insertKnot);
  connect(&net, &FactorNet::hovered, this, [this](const QString& what) {
    if (std::exchange(said_, what) == what) return;
    emit changed();
  });
  connect(&panel.ball(), &TurnBall::turned, this, &FactorsTool::dragBall);
  connect(&net, &FactorNet::dropped, this, &FactorsTool::dropPanel);
  connect(&panel.ball(), &TurnBall::dropped, this, &FactorsTool::dropPanel);
  connect(&net, &FactorNet::cancelled, this, &FactorsTool::cancelPanel);
  connect(&panel.ball(), &TurnBall::cancelled, this, &FactorsTool::cancelPanel);
}

/// Selected, factors would open their card again.
void FactorsTool::close() {
  const QPointer<FactorsTool> self(this);
  const std::vector<FeatureId> selected = host().selection();
  const Document& document = host().document();
  const auto opens = [&](const FeatureId& id) { return document.contains(id) && document.at(id).type == factorsType; };
  if (std::any_of(selected.begin(), selected.end(), opens)) host().select({});
  if (self) emit finished();
}

void FactorsTool::chooseFactor(Factor factor) {
  cancelPanel();
  factor_ = factor;
  chosen_.clear();
  forgetHovered();
  panel_->setFactor(factor);
  if (surface_) panel_->net().setPoles(layoutOf(surface_->motion(), factor));
  fillPanel();
  emit changed();
}

void FactorsTool::fillPanel() {
  if (!panel_ || !surface_) return;
  const FactorLayout& layout = panel_->net().poles();
  panel_->net().setSigns(signSizes(motion(), layout), signDirections(motion(), layout));
  std::array<std::vector<double>, FactorsPanel::fieldCount> values;
  for (const FactorPole& pole : chosen_) {
    if (!layout.contains(pole)) return;  // of the motion before a knot was taken back; the net tells what is left
    const PoleValue value = poleValue(motion(), factor_, pole);
    const double largest = value.vector.cwiseAbs().maxCoeff();
    for (int k = 0; k < weightField; ++k)
      values[static_cast<std::size_t>(k)].push_back(ui::withoutNoise(value.vector[k], largest));
    values.back().push_back(value.weight);
  }
  FactorsPanel::Texts texts;
  for (int k = 0; k < FactorsPanel::fieldCount; ++k)
    texts[static_cast<std::size_t>(k)] =
        common(specOfField(factor_, k), values[static_cast<std::size_t>(k)], host().lengthUnit());
  panel_->setValues(texts, !chosen_.empty());
  panel_->setSummary(summary());
  if (!chosen_.empty() && factor_ == Factor::Orientation)
    panel_->ball().setFrame(motion().orientation.pole(chosen_.begin()->row, chosen_.begin()->column));
  look();
  fillPlot();
}

QString FactorsTool::summary() const {
  if (chosen_.empty()) return tr("No pole is chosen");
  if (chosen_.size() > 1) return tr("%1 poles").arg(chosen_.size());
  const FactorPole& pole = *chosen_.begin();
  const FactorLayout& layout = panel_->net().poles();
  const auto [u0, u1] = layout.reachU[pole.row];
  const auto [v0, v1] = layout.reachV[pole.column];
  const auto range = [](const char* name, double from, double to) {
    return QStringLiteral("%1 %2 … %3").arg(QLatin1String(name), ui::readable(from, 3), ui::readable(to, 3));
  };
  if (factor_ == Factor::Trajectory) return tr("Pole %1 · reaches %2").arg(pole.column).arg(range("v", v0, v1));
  return tr("Pole (%1, %2) · reaches %3, %4").arg(pole.row).arg(pole.column).arg(range("u", u0, u1), range("v", v0, v1));
}

void FactorsTool::fillPlot() {
  if (!panel_ || !surface_) return;
  const FactorLayout& layout = panel_->net().poles();
  const FactorPole pole = chosen_.empty() ? FactorPole{} : *chosen_.begin();
  if (!layout.contains(pole)) return;
  const bool alongU = panel_->alongU() && factor_ != Factor::Trajectory;
  const CombAlong along = alongU ? CombAlong::U : CombAlong::V;
  const double u = layout.us[pole.row], v = layout.vs[pole.column];
  const double across = alongU ? v : u, mark = alongU ? u : v;
  const QString at =
      alongU ? tr("along u at v = %1").arg(ui::readable(v, 3)) : tr("along v at u = %1").arg(ui::readable(u, 3));
  const QString line = chosen_.empty() ? tr("%1, the first pole").arg(at) : at;
  if (factor_ == Factor::Trajectory) {
    const TrajectoryComb comb = trajectoryComb(motion(), plotSamples);
    panel_->plot().setCurves(tr("Curvature along v, 1/mm"),
                             {barCurve(comb.at, comb.curvature, hardlyBent(motion(), layout), 1)}, mark);
  } else if (factor_ == Factor::Orientation) {
    const OrientationComb comb = orientationComb(motion(), along, across, plotSamples);
    constexpr double hardlyTurning = 1e-9;
    panel_->plot().setCurves(tr("Angular velocity, ° per range, %1").arg(line),
                             {barCurve(comb.at, comb.velocity, hardlyTurning, toDegrees(1))}, mark);
  } else {
    panel_->plot().setCurves(tr("Factors with curvature, %1").arg(line),
                             scalingCurves(scalingComb(motion(), along, across, plotSamples)), mark);
  }
}

/// The trackball shows what the view sees.
void FactorsTool::look() {
  if (panel_) panel_->ball().setFacing(facing(towards_, millimetresPerPixel()));
}

void FactorsTool::dragNet(const QPointF& pixels) {
  if (!editable() || held()) return;
  if (factor_ == Factor::Orientation) {
    const auto axis = typedAxis();
    if (!axis) return;
    const double degrees = draggedDegrees(pixels);
    return dragPanel(turnedPoles(chosen_, *axis, degrees, false),
                     tr("Let go to turn by %1° · Esc takes it back").arg(degrees));
  }
  const double factor = draggedFactor(pixels);
  if (factor_ == Factor::Trajectory)
    return dragPanel(weightedPoles(surface_->motion(), factor_, chosen_, factor),
                     tr("Let go to multiply the weight by %1 · Esc takes it back").arg(factor));
  Vec3 factors = Vec3::Ones();
  for (int k = 0; k < 3; ++k)
    if (panel_->scaled()[static_cast<std::size_t>(k)]) factors[k] = factor;
  dragPanel(scaledPoles(chosen_, factors), tr("Let go to scale by %1 · Esc takes it back").arg(factor));
}

void FactorsTool::dragBall(const Vec3& turn) {
  if (!editable() || held() || factor_ != Factor::Orientation) return;
  constexpr double tenths = 10;
  const double degrees = std::round(toDegrees(turn.norm()) * tenths) / tenths;
  const Vec3 axis = turn.norm() > 0 ? Vec3(turn.normalized()) : Vec3::UnitZ();
  dragPanel(turnedPoles(chosen_, axis, degrees, false), tr("Let go to turn by %1° · Esc takes it back").arg(degrees));
}

void FactorsTool::dragPanel(const FactorChanges& changes, const QString& what) {
  if (chosen_.empty()) return;
  onPanel_ = true;
  if (!live_) startLive();
  said_ = what;
  follow(changes);
  emit changed();
}

void FactorsTool::dropPanel() {
  if (!std::exchange(onPanel_, false) || !live_) return;
  said_.clear();
  if (live_->possible() && editable() && withChangedFactors(surface_->motion(), live_->changes()).changedPoles > 0)
    commitDrag(undoTextOf(live_->changes()));
  live_.reset();
  fillPanel();
  drawMotion();
  emit changed();
}

void FactorsTool::cancelPanel() {
  if (!std::exchange(onPanel_, false)) return;
  live_.reset();
  said_.clear();
  fillPanel();
  drawMotion();
  emit changed();
}

QString FactorsTool::undoTextOf(const FactorChanges& changes) {
  if (!changes.orientation.empty()) return tr("Turn poles of the orientation");
  if (!changes.scaling.empty()) return tr("Scale poles");
  return changes.weights.empty() ? tr("Move poles of the trajectory") : tr("Change weights of the trajectory");
}

std::optional<double> FactorsTool::typedNumber(int field, const QString& text) {
  try {
    const ParameterSpec spec = specOfField(factor_, field);
    return checked(spec, parseText(spec, text.toStdString(), host().lengthUnit())).get<double>();
  } catch (const std::exception& problem) {
    panel_->refuse(field, ui::qt(problem.what()));
    return std::nullopt;
  }
}

std::optional<Vec3> FactorsTool::typedAxis() {
  Vec3 axis;
  for (int k = 0; k < 3; ++k) {
    const auto number = typedNumber(k, panel_->text(k));
    if (!number) return std::nullopt;
    axis[k] = *number;
  }
  return axis;
}

void FactorsTool::type(int field, const QString& text) {
  // Axis and angle are for the buttons beside the trackball.
  if (!editable() || chosen_.empty() || factor_ == Factor::Orientation) return;
  if (text.trimmed().isEmpty()) return fillPanel();
  const auto number = typedNumber(field, text);
  if (!number) return;
  const FactorChanges changes = field == weightField ? weightSet(surface_->motion(), factor_, chosen_, *number)
                                                     : placedPoles(surface_->motion(), factor_, chosen_, field, *number);
  enter(changes, undoTextOf(changes), field);
}

void FactorsTool::turn(bool absolute) {
  if (!editable() || chosen_.empty()) return;
  panel_->forgive();
  const auto axis = typedAxis();
  const auto degrees = axis ? typedNumber(weightField, panel_->text(weightField)) : std::nullopt;
  if (!degrees) return;
  const FactorChanges changes = turnedPoles(chosen_, *axis, *degrees, absolute);
  enter(changes, undoTextOf(changes), weightField);
}

}  // namespace blossom::sweep
