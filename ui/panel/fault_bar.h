#pragma once
#include "document/document.h"
#include "ui/panel/error_bar.h"

namespace blossom::ui {

class Session;

/// Above the view while a feature fails: which one, why and where, and what to do. It tells of the selected feature, or else
/// of the first one that failed, with a way to it. Once dismissed it comes again for another failure only. While something
/// is dragged it stays as it is, so that the view keeps its size.
class FaultBar final : public ErrorBar {
  Q_OBJECT
 public:
  explicit FaultBar(const Session&, QWidget* parent = nullptr);
  /// The feature whose failure comes before those of others; empty: none is selected.
  void setSelected(const FeatureId&);

 signals:
  void featureWanted(const QString& feature);  ///< it should be selected

 private:
  [[nodiscard]] const Feature* failed() const;
  void refresh();
  void tell(const Feature&);
  void forget();

  const Session& session_;
  FeatureId selected_;
  FeatureId told_;  ///< the feature told of last, whether or not that was dismissed
  QString why_;
  bool wayOffered_ = false;
};

}  // namespace blossom::ui
