#pragma once
#include <array>

#include "manipulators/factors/factor_net.h"
#include "ui/tools/floating_panel.h"

class QButtonGroup;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QToolButton;

namespace blossom::sweep {

class CombPlot;
class TurnBall;

/// The card over the view in which the factors of a motion are edited: a net of poles, the comb of one line of it, and the
/// numbers of the chosen poles. It shows what it is given; the tool decides.
class FactorsPanel final : public ui::FloatingPanel {
  Q_OBJECT
 public:
  /// The fields: three coordinates and a weight; of the orientation an axis and an angle.
  static constexpr int fieldCount = 4;
  using Texts = std::array<QString, fieldCount>;

  explicit FactorsPanel(QWidget* view);

  void setFactor(Factor);
  /// Fields that are being typed in are left alone. @param editable poles are chosen, and can be changed
  void setValues(const Texts&, bool editable);
  void setSummary(const QString&);
  /// Says why the text of a field was refused; it stays there until something else is typed or chosen.
  /// @param field of -1: what was refused was not typed
  void refuse(int field, const QString& why);
  void forgive();
  [[nodiscard]] FactorNet& net() const { return *net_; }
  [[nodiscard]] CombPlot& plot() const { return *plot_; }
  [[nodiscard]] TurnBall& ball() const { return *ball_; }
  /// The combs run along u, else along v.
  [[nodiscard]] bool alongU() const;
  /// The factors x, y, z that a drag in the net scales.
  [[nodiscard]] std::array<bool, 3> scaled() const;
  [[nodiscard]] bool showsFrames() const;
  [[nodiscard]] bool showsIsoCurves() const;
  [[nodiscard]] bool showsCombs() const;
  [[nodiscard]] QString text(int field) const;

 signals:
  void closeWanted();
  void factorChosen(blossom::sweep::Factor factor);
  void typed(int field, const QString& text);
  void turnWanted(bool absolute);  ///< by the axis and the angle in the fields
  void displayChosen();            ///< frames, iso-curves, combs, or the direction of combs

 protected:
  bool event(QEvent*) override;

 private:
  [[nodiscard]] static QToolButton* checkButton(const QString& text, const QString& help);
  void build();
  [[nodiscard]] QHBoxLayout* factorRow();
  [[nodiscard]] QGridLayout* fieldGrid();
  [[nodiscard]] QHBoxLayout* turnRow();
  [[nodiscard]] QHBoxLayout* displayRow();
  void labelFields(Factor);
  void enter(int field);
  [[nodiscard]] QLineEdit* fieldOfTyping() const;
  void takeBackTyping();
  void showKnown(std::size_t field);
  [[nodiscard]] static bool isRefused(const QLineEdit& field);

  QButtonGroup *factors_, *directions_;
  FactorNet* net_;
  CombPlot* plot_;
  TurnBall* ball_;
  std::array<QToolButton*, fieldCount> names_{};
  std::array<QLineEdit*, fieldCount> fields_{};
  Texts known_;  ///< of the chosen poles
  QWidget* turning_;
  QPushButton *turn_, *set_;
  QToolButton *frames_, *iso_, *combs_;
  QLabel *summary_, *problem_;
  Factor factor_ = Factor::Scaling;
};

}  // namespace blossom::sweep
