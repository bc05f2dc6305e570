#pragma once
#include <QWidget>
#include <memory>
#include <vector>

#include "parameter/parameter.h"
#include "ui/fields/pick_request.h"

class QLabel;
class QGridLayout;
class QToolButton;
class QMenu;

namespace blossom::ui {

class FieldLabel;
struct Pick;

inline constexpr int labelWidth = 92;  ///< of the names in a form, pixels

/// What the form around a field offers it. In a dialog there is no view to pick in and there are no inputs.
struct FieldContext {
  struct Source {
    std::string input;  ///< name of the input spec
    FeatureId feature;
    QString name;
  };
  bool picking = false;
  std::vector<Source> sources;  ///< the shapes whose faces, edges and vertices may be named

  /// "Face 3 of Base"; brief: "Face 3" where there is only one shape that it can be of.
  [[nodiscard]] QString nameOf(const Value& subShape, bool brief = false) const;
};

/// One parameter in a form, made from its declaration: label, editor for its kind, and room for what is wrong with the
/// value. A drag shows previews and ends as one edit; Esc takes back what is not yet an edit.
class ParameterField : public QWidget {
  Q_OBJECT
 public:
  using Context = std::shared_ptr<const FieldContext>;

  /// The editor that fits the kind, whatever it holds.
  static ParameterField* make(const ParameterSpec&, QWidget* parent = nullptr, const Context& = nullptr);

  [[nodiscard]] const ParameterSpec& spec() const { return spec_; }
  /// Shows a value without telling anyone.
  void setValue(const Value&);
  [[nodiscard]] const Value& value() const { return value_; }
  /// The value as the document keeps it: an expression stays as it was typed, for all it comes to a plain number.
  [[nodiscard]] virtual Value written() const { return value_; }
  /// What the document holds; comes before setValue of what it comes to.
  virtual void setWritten(const Value&) {}
  /// What is wrong with what was typed, or what the evaluation says of this parameter.
  [[nodiscard]] QString problem() const;
  /// Shown like a wrong value until the value changes; empty: nothing is wrong.
  void setFault(const QString&);
  /// Whether something is dragged or typed that is not yet an edit.
  [[nodiscard]] virtual bool editing() const { return previewing_; }
  /// Takes back what is dragged or typed.
  void revert();
  /// Puts in what was picked in the view. @returns whether it was what is wanted; why not is said below the editor.
  virtual bool takePick(const Pick&) { return false; }
  virtual void pickEnded() {}
  void resetToDefault();
  /// For fields in rows of a list: no label, no way back to the default.
  virtual void hideLabel();
  /// Fields in groups keep their editors in line with those outside.
  void indentLabel(int pixels);

 signals:
  void previewed(const blossom::Value&);  ///< while something is dragged
  void edited(const blossom::Value&);     ///< checked and different from before
  void reverted();                        ///< what was previewed holds no longer
  void hint(const QString&);
  /// `field` is the one that will take the pick; fields in lists and records put the path in front.
  void pickWanted(blossom::ui::ParameterField* field, const blossom::ui::PickRequest&);
  void pickUnwanted(blossom::ui::ParameterField* field);

 protected:
  ParameterField(ParameterSpec spec, Context context, QWidget* parent);
  void setEditor(QWidget*);
  /// Below the label, as wide as the form; `corner` stands to the right of the label.
  void setWideEditor(QWidget*, QWidget* corner = nullptr);
  /// Checks and passes on; a wrong value is named below the editor and the old one kept.
  void offer(const Value&, bool preview = false);
  void offerText(const QString&);
  void showProblem(const QString&);
  /// A line in calm colour: what an expression comes to.
  void showNote(const QString&);
  [[nodiscard]] FieldLabel& caption() const { return *caption_; }
  [[nodiscard]] const Context& context() const { return context_; }
  virtual void display(const Value&) = 0;
  virtual void addToMenu(QMenu&) {}
  bool event(QEvent*) override;
  void enterEvent(QEnterEvent*) override;
  void leaveEvent(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;

 private:
  void refreshMarks();
  [[nodiscard]] bool differsFromDefault() const;

  ParameterSpec spec_;
  Context context_;
  Value value_;
  bool previewing_ = false;
  bool labelled_ = true;
  QGridLayout* grid_;
  FieldLabel* caption_;
  QWidget* editor_ = nullptr;
  QWidget* corner_ = nullptr;
  QLabel* note_;
  QLabel* problem_;
  QToolButton* reset_;
};

/// The value as a form writes it, with its unit.
QString displayText(const ParameterSpec&, const Value&);
/// What was typed; lengths without a unit are in the one the user prefers. @throws Error InvalidParameter.
Value parseTyped(const ParameterSpec&, const QString& text);
/// The name of a parameter as a form shows it; those of preferences are translated.
QString shownLabel(const ParameterSpec&);
/// Likewise the name of a choice.
QString shownChoice(const std::string&);
/// What a new item of a list begins with; null where only the user can tell.
Value startValue(const ParameterSpec&);

}  // namespace blossom::ui
