#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <QObject>
#include <QPointF>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <typeinfo>
#include <vector>

#include "core/units.h"
#include "document/document.h"
#include "document/evaluator.h"
#include "geometry/shape/bounds.h"
#include "parameter/parameter.h"
#include "scene/picking.h"
#include "scene/scene.h"

class QKeyEvent;
class QWidget;
class vtkProp;

namespace blossom::ui {

/// A feature, or one of its faces, edges or vertices, under the mouse.
struct Pick {
  FeatureId feature;  ///< empty: nothing is there
  SubPick part;       ///< kind Whole when the feature was hit but no sub-shape has a number
};

/// Objects that are found under the mouse: features, sub-shapes of one kind, or whatever is nearest.
enum class PickMode { None, Feature, Face, Edge, Vertex, Any };

inline constexpr double clickReach = 4;  ///< pixels of movement up to which a press and release is a click, not a drag

/// A mouse event for tools.
struct ToolEvent {
  QPointF at;  ///< logical pixels from the upper left of the view
  Ray ray;     ///< under the cursor, into the scene
  Pick pick;   ///< the nearest object under the cursor
  Qt::MouseButton button = Qt::NoButton;
  Qt::KeyboardModifiers modifiers;
  double millimetresPerPixel = 1;  ///< at the camera's target
};

/// A picture of a shape while a tool changes it, drawn instead of features in the colours and the display mode of what is
/// being made. Points and normals may be changed in place between two calls of `Tool::standIn`, cells may not.
struct StandIn {
  std::vector<FeatureId> insteadOf;    ///< those of them that are shown are hidden meanwhile
  vtkSmartPointer<vtkPolyData> faces;  ///< triangles, with a normal for each point
  vtkSmartPointer<vtkPolyData> edges;  ///< polylines; null: none
  /// The same with fewer triangles, shown while frames take too long; null: there is nothing coarser.
  vtkSmartPointer<vtkPolyData> coarseFaces = nullptr;
};

/// Interface of the workbench for tools.
class ToolHost {
 public:
  virtual ~ToolHost() = default;
  [[nodiscard]] virtual const Document& document() const = 0;
  /// Newest result of a feature; nullptr while there is none.
  [[nodiscard]] virtual std::shared_ptr<const FeatureResult> result(const FeatureId&) const = 0;
  [[nodiscard]] virtual const Registry& registry() const = 0;
  [[nodiscard]] virtual const Look& look() const = 0;
  /// Current spacing of the ground grid in mm.
  [[nodiscard]] virtual double gridSpacing() const = 0;
  /// The preferred unit of lengths.
  [[nodiscard]] virtual LengthUnit lengthUnit() const { return {}; }
  /// What the document keeps of a text typed for a parameter: a number, or an expression as such, which may use the named
  /// numbers of the document. @throws Error InvalidParameter.
  [[nodiscard]] virtual Value typed(const ParameterSpec& spec, const QString& text) const {
    return parseText(spec, text.toStdString(), lengthUnit());
  }
  [[nodiscard]] virtual std::vector<FeatureId> selection() const = 0;
  virtual void select(const FeatureId&) = 0;
  /// The plane of the section; empty: no section.
  [[nodiscard]] virtual std::optional<CutPlane> section() const { return std::nullopt; }
  virtual void setSection(const std::optional<CutPlane>&) {}
  /// Bounding box of everything visible; empty when there is nothing.
  [[nodiscard]] virtual Bounds extent() const { return {}; }
  /// Where a point is seen, in logical pixels from the upper left of the view; empty where there is no view.
  [[nodiscard]] virtual std::optional<QPointF> onScreen(const Vec3&) const { return std::nullopt; }
  /// Device pixels per logical pixel of the view.
  [[nodiscard]] virtual double pixelRatio() const { return 1; }
  /// The view, for a card that floats over it (ui/tools/floating_panel.h); nullptr where there is none.
  [[nodiscard]] virtual QWidget* viewWidget() const { return nullptr; }
  /// Which of the frames of a sequence the timeline shows.
  [[nodiscard]] virtual int shownFrame(int /*frames*/) const { return 0; }
  /// Shows the other frames of sequences faintly, whatever the timeline asks for; until it is taken back.
  virtual void showOtherFrames(bool /*on*/) {}
  /// What the tools of a kind leave to those after them while the document is open, such as a mode that keys chose: one
  /// value of each type, as it is made without arguments at first.
  template <class T>
  [[nodiscard]] T& kept() {
    std::shared_ptr<void>& place = kept_[typeid(T).name()];
    if (!place) place = std::make_shared<T>();
    return *static_cast<T*>(place.get());
  }
  /// Shows a document without recording it; ended by the next commit or by endPreview.
  virtual void preview(Document) = 0;
  /// The same with the results of a coarser document, whose sequences may have fewer frames: everything but the shapes is
  /// that of the first one.
  virtual void previewCoarsely(const Document& document, const Document& /*coarser*/) { preview(document); }
  virtual void endPreview() = 0;
  /// One step of undo.
  virtual void commit(Document, const QString& what) = 0;
  /// The same where the whole takes long: the results of a coarser document are shown until it is there.
  virtual void commitCoarselyFirst(Document document, const QString& what, const Document& /*coarser*/) {
    commit(std::move(document), what);
  }

 private:
  std::map<std::string, std::shared_ptr<void>> kept_;
};

/// One interaction in the view: a state machine that ends in a commit or reverts everything. While active it receives mouse
/// and keys first; events that it does not accept move the camera. Lives in the window's thread.
class Tool : public QObject {
  Q_OBJECT
 public:
  explicit Tool(ToolHost& host) : host_(host) {}

  /// What a click or drag would do now, for the status line.
  [[nodiscard]] virtual QString hint() const = 0;
  /// Each returns whether the event was accepted.
  virtual bool press(const ToolEvent&) { return false; }
  virtual bool move(const ToolEvent&) { return false; }  ///< also without a button
  virtual bool release(const ToolEvent&) { return false; }
  virtual bool doubleClick(const ToolEvent&) { return false; }
  virtual bool key(const QKeyEvent&) { return false; }  ///< if Esc is not accepted, it ends the tool
  virtual void mouseGone() {}                           ///< it has left the view
  /// Turns of the wheel away from the user, in notches, before the camera has them.
  virtual bool wheel(double /*notches*/, Qt::KeyboardModifiers) { return false; }
  /// The keys go elsewhere from now on: what is being typed is left as by Esc.
  virtual void keysLost() {}
  /// The point of a shape that the mouse is at or takes along, where the tool knows it; told at the end of the status line
  /// in place of the point of the ground.
  [[nodiscard]] virtual std::optional<Vec3> whereabouts() const { return std::nullopt; }
  /// Something is being typed: the hint stays in the status line wherever the mouse goes.
  [[nodiscard]] virtual bool entering() const { return false; }
  /// What `undo` and `redo` would take back and give again of what the tool has begun, "the last point"; empty: the
  /// document's last change is meant.
  [[nodiscard]] virtual QString undoText() const { return {}; }
  [[nodiscard]] virtual QString redoText() const { return {}; }
  virtual void undo() {}
  virtual void redo() {}
  /// The normal of the plane that the tool draws in, to which the view turns as it begins; empty: the view stays.
  [[nodiscard]] virtual std::optional<Vec3> drawsIn() const { return std::nullopt; }
  /// The objects that `ToolEvent::pick` finds and that are highlighted under the mouse.
  [[nodiscard]] virtual PickMode picks() const { return PickMode::Any; }
  /// Objects drawn over the scene, never picked. Called before the next frame after `changed`, however often it came. To be
  /// made anew each time: the view keeps them and may change what they hold.
  [[nodiscard]] virtual std::vector<vtkSmartPointer<vtkProp>> props() const { return {}; }
  /// A shape that stands in for features; empty: they are shown themselves. Called like `props`.
  [[nodiscard]] virtual std::optional<StandIn> standIn() const { return std::nullopt; }
  /// The document changed under the tool (undo, a new result). A tool whose feature is gone should emit finished().
  virtual void documentChanged() {}
  virtual void frameMoved() {}  ///< the timeline shows another frame
  /// Called before `revert` where another command takes the tool's place: commits what has been begun, if it can stay.
  virtual void conclude() {}
  /// Called when the tool is ended from outside (Esc, another tool): reverts previews.
  virtual void revert() {}

 signals:
  void changed();   ///< props or hint
  void finished();  ///< the tool has committed or was cancelled and asks to be removed

 protected:
  [[nodiscard]] ToolHost& host() const { return host_; }

 private:
  ToolHost& host_;
};

}  // namespace blossom::ui
