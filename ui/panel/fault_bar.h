#pragma once
#include "document/document.h"
#include "ui/panel/error_bar.h"

namespace blossom::ui {

class Session;

/// A bar over the view while a feature fails: its name, the reason, the place and the remedy. Shows the selected feature or
/// else the first that failed, with a button to select it. Once dismissed it appears only for another failure. During a drag
/// it does not change.
class FaultBar final : public ErrorBar {
  Q_OBJECT
 public:
  explicit FaultBar(const Session&, QWidget* parent = nullptr);
  /// The selected feature, whose failure takes precedence; empty: none.
  void setSelected(const FeatureId&);

 signals:
  void featureWanted(const QString& feature);  ///< asks to select it

 private:
  [[nodiscard]] const Feature* failed() const;
  void refresh();
  void tell(const Feature&);
  void forget();

  const Session& session_;
  FeatureId selected_;
  FeatureId told_;  ///< the feature shown last, dismissed or not
  QString why_;
  bool wayOffered_ = false;
};

}  // namespace blossom::ui
