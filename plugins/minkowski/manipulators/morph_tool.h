#pragma once
#include <QPointer>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/planar/region.h"
#include "kernel/morph/control_placement.h"
#include "manipulators/ladder_loader.h"
#include "manipulators/morph_ladder.h"
#include "parameter/parameter.h"
#include "ui/tools/handle_tool.h"
#include "ui/tools/typed_text.h"

namespace blossom::minkowski {

class MorphCard;
class PathPoints;

/// The control shapes of a morph where they stand in it. The dot at the centre of each, and its number, move it; a ring
/// around the one that the mouse is near or that was clicked last holds a square that scales it and a dot that turns it. A
/// drag sets the parameters `offsets`, `scales` and `turns`: the document is previewed meanwhile, numbers can be typed
/// instead, and the whole drag is one step of undo. A card tells t and area of what is seen, holds the pad on which the path
/// through the blossom is drawn, and switches the ladder of de Casteljau, which is computed in the background; a click on
/// one of its legs shows the shape there.
class MorphTool final : public ui::HandleTool {
  Q_OBJECT
 public:
  MorphTool(ui::ToolHost&, FeatureId);
  ~MorphTool() override;

  [[nodiscard]] QString hint() const override;
  bool press(const ui::ToolEvent&) override;
  bool move(const ui::ToolEvent&) override;
  bool release(const ui::ToolEvent&) override;
  bool doubleClick(const ui::ToolEvent&) override;
  bool key(const QKeyEvent&) override;
  void keysLost() override;
  void documentChanged() override;
  void frameMoved() override;
  void revert() override;
  [[nodiscard]] bool entering() const override { return typing_; }
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const override;

  static constexpr double ringPixels = 40;  ///< radius of the ring: it clears the number above the dot

 private:
  /// What of a control shape is taken hold of.
  enum class Grip : std::size_t { Move, Scale, Turn };
  static constexpr std::size_t gripCount = 3;
  struct Handle {
    std::size_t shape;
    Grip grip;
  };
  /// A control shape as it was drawn.
  struct Control {
    Region region;
    Vec2 centre = Vec2::Zero();
    QString name;
  };

  // What the base class calls.
  void load() override;
  [[nodiscard]] std::optional<std::size_t> handleUnder(const ui::ToolEvent&) const override;
  bool take(std::size_t handle, const ui::ToolEvent&) override;
  void drag(const ui::ToolEvent&) override;
  void place() override;
  void putBack() override;

  // Handles.
  [[nodiscard]] static std::size_t numberOf(std::size_t shape, Grip);
  [[nodiscard]] static Handle handleOf(std::size_t number);
  [[nodiscard]] Vec2 centreOf(std::size_t shape) const { return controls_[shape].centre + placements_[shape].offset; }
  [[nodiscard]] double ringRadius(std::size_t shape, double millimetresPerPixel) const;
  [[nodiscard]] Vec2 gripAt(std::size_t shape, Grip, double millimetresPerPixel) const;
  [[nodiscard]] std::optional<std::size_t> nearest(const ui::ToolEvent&, double pixels) const;
  [[nodiscard]] double badgeShift(std::size_t shape, double millimetresPerPixel) const;
  [[nodiscard]] std::optional<std::size_t> badgeUnder(const ui::ToolEvent&) const;
  [[nodiscard]] std::optional<std::size_t> shapeNear(const ui::ToolEvent&) const;
  void showRingOf(std::optional<std::size_t> shape);
  [[nodiscard]] Placement dragged(const Handle&, const ui::ToolEvent&, const Vec2& at) const;
  void follow(const Placement&);
  [[nodiscard]] Document with(const std::vector<Placement>&) const;
  [[nodiscard]] Document coarser(const Document&) const;
  [[nodiscard]] double coarseTolerance() const;

  // Numbers that are typed.
  bool typingKey(const QKeyEvent&);
  [[nodiscard]] double typedNumber(ParameterSpec, const char* name, const QString& text) const;
  [[nodiscard]] Placement typedPlacement() const;
  void followTyped();
  void takeTyped();
  void stopTyping();

  // The card and the ladder.
  void makeCard();
  void refreshCard();
  void setLadder(bool on);
  void askLadder(const Value& parameters);
  void showInfluences(const Value& parameters);
  [[nodiscard]] const Shape& shapeSeen(const Shape&) const;
  [[nodiscard]] std::optional<double> timeSeen(const Value& parameters) const;
  [[nodiscard]] QString figures(const Region*);
  [[nodiscard]] QString ladderNote(const Value& parameters) const;

  // A leg of the ladder.
  [[nodiscard]] std::vector<Vec2> centres() const;
  [[nodiscard]] std::optional<LadderLeg> legUnder(const ui::ToolEvent&) const;
  [[nodiscard]] const LadderShape* shapeOn(const LadderLeg&) const;
  [[nodiscard]] QString legNote() const;
  void forgetLostLeg();
  void forgetOldLadder();

  // The path through the blossom.
  void connectPad();
  void setPathOpen(bool open);
  [[nodiscard]] bool shapesKnown() const;
  [[nodiscard]] bool hasPath(const Value& parameters) const;
  void refreshPad(const Value& parameters);
  void previewPath();
  void keepPath();
  void putPathBack();
  [[nodiscard]] Document with(const PathPoints&) const;

  // What is said and drawn.
  [[nodiscard]] QString heldHint(const Handle&) const;
  [[nodiscard]] QString hoverHint(const Handle&) const;
  [[nodiscard]] QString valueText(const Handle&) const;
  [[nodiscard]] QString offsetText(const Vec2&) const;
  void drawLadder(std::vector<vtkSmartPointer<vtkProp>>&) const;
  void drawLeg(std::vector<vtkSmartPointer<vtkProp>>&) const;
  void drawShapes(std::vector<vtkSmartPointer<vtkProp>>&) const;
  void drawRing(std::vector<vtkSmartPointer<vtkProp>>&, std::size_t shape) const;

  Document base_;  ///< the document that a drag starts from, on the pad as well
  std::vector<Control> controls_;
  bool moving_ = false;                ///< some of them are sequences
  std::vector<Placement> placements_;  ///< one for each control shape
  std::vector<Placement> before_;
  std::optional<std::size_t> chosen_;   ///< the control shape that was clicked last
  std::optional<std::size_t> ringed_;   ///< the one that has its ring now
  double ringScale_ = 0;                ///< mm per pixel by which the ring was drawn
  Vec2 grabbed_ = Vec2::Zero();         ///< from the centre of the shape to the mouse at the start of the drag
  std::optional<ui::ToolEvent> mouse_;  ///< what it did last during the drag
  bool typing_ = false;
  ui::TypedText entry_;
  QString refusal_;

  MorphHabits& habits_;  ///< stay in force when something else is selected meanwhile
  QPointer<MorphCard> card_;
  std::vector<double> levels_;  ///< the numbers by which what is seen is blended
  std::shared_ptr<const FeatureResult> measured_;
  const Region* measuredRegion_ = nullptr;  ///< of it
  std::vector<double> measuredLevels_;      ///< of that
  double area_ = 0;                         ///< mm^2, of that
  std::shared_ptr<const LadderLines> ladder_;
  std::optional<LadderLeg> legHovered_, legShown_;
  bool legPressed_ = false;
  bool drawingPath_ = false;  ///< it is previewed
  LadderLoader loader_;
};

}  // namespace blossom::minkowski
