#pragma once
#include <QObject>
#include <QPointer>
#include <optional>

#include "ui/fields/pick_request.h"

namespace blossom::ui {

class InputEditor;
class ParameterField;
struct Pick;

/// What a field or an input of the property panel wants to be picked in the view, and who gets it.
class PanelPicking : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// For a field, or for an input when that is nullptr. What was wanted before is no longer.
  void want(ParameterField*, InputEditor*, const PickRequest&);
  [[nodiscard]] const std::optional<PickRequest>& wanted() const { return wanted_; }
  [[nodiscard]] bool isFor(const ParameterField*) const;
  [[nodiscard]] bool isFor(const InputEditor*) const;
  /// Something was picked. Does nothing while nothing is wanted.
  void offer(const Pick&);
  void end();

 signals:
  void begun(const blossom::ui::PickRequest&);
  void ended();

 private:
  std::optional<PickRequest> wanted_;
  QPointer<ParameterField> field_;
  QPointer<InputEditor> input_;
};

}  // namespace blossom::ui
