#pragma once
#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <string>

#include "scene/camera.h"
#include "ui/plugin/manipulator.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

class ViewWidget;

/// The tools of a page: one that the user has started, or the handles of the selected feature while there is none. Gives the
/// view the one that gets mouse and keys.
class PageTools : public QObject {
  Q_OBJECT
 public:
  PageTools(ToolHost&, const ManipulatorRegistry&, ViewWidget&);

  [[nodiscard]] Tool* tool() const { return tool_ ? tool_.get() : handles_.get(); }
  [[nodiscard]] Tool* started() const { return tool_.get(); }  ///< by the user; nullptr: none
  /// The one before is concluded.
  void start(std::unique_ptr<Tool>);
  /// Draws a new feature of a type, or edits one; false when the type has no tool of its own.
  bool startDrawing(const std::string& featureType, const FeatureId& edited);
  void end();
  void conclude();  ///< the same, but what has been begun and can stay does
  void drop();      ///< all of them, before the view goes
  /// The selection, the document or a result has changed.
  void refreshHandles();

 signals:
  void changed();
  void drawn();         ///< a tool that draws in a plane has ended by itself
  void stepsChanged();  ///< what Undo and Redo would do with the tool that was started
  void hint(const QString&);
  void failed(const blossom::Error&);

 private:
  void follow(Tool&);
  void makeHandles(const MakeTool&, const FeatureId&);
  void giveViewItsTool();
  void tellSteps();
  void turnToPlane(const Vec3& normal);
  void turnBack();

  ToolHost& host_;
  const ManipulatorRegistry& manipulators_;
  ViewWidget& view_;
  std::unique_ptr<Tool> tool_, handles_;
  FeatureId handled_;
  QStringList steps_;
  struct Turned {
    Turn before, during;
  };
  std::optional<Turned> turned_;  ///< the view, to the plane of the tool
};

}  // namespace blossom::ui
