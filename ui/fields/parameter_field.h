#pragma once
#include <QWidget>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "naming/likeness.h"
#include "parameter/parameter.h"
#include "ui/fields/pick_request.h"
#include "ui/plugin/tool.h"

class QLabel;
class QGridLayout;
class QLineEdit;
class QToolButton;
class QMenu;

namespace blossom::ui {

class FieldLabel;

inline constexpr int labelWidth = 92;  ///< of the names in a form, pixels

/// What the surrounding form provides to a field. In a dialog there is no view to pick in and there are no inputs.
struct FieldContext {
  struct Source {
    std::string input;  ///< name of the input spec
    FeatureId feature;
    QString name;
  };
  bool picking = false;
  std::vector<Source> sources;                ///< shapes whose faces, edges and vertices may be chosen
  std::map<std::string, std::size_t> shapes;  ///< how many each input has, by its name
  Value parameters = Value::object();         ///< of the feature: canonical, the default where one is wrong
  NamedNumbers names;                         ///< numbers that expressions may use
  std::vector<Value> lost;                    ///< parts that the feature did not find again
  /// What a part that was picked looks like; nothing when its shape is not known.
  std::function<std::optional<Likeness>(const Pick&)> likenessOf = [](const Pick&) { return std::nullopt; };
  /// What a field holds for which more is picked, and the part whose chip the mouse is on: marked in the view until the next
  /// call.
  std::function<void(const std::vector<Pick>&)> markChosen = [](const std::vector<Pick>&) {};
  std::function<void(const std::optional<Pick>&)> markPointed = [](const std::optional<Pick>&) {};
  /// Sets a key of the feature's sequence where the timeline is, in the document. False where the feature has no sequence.
  std::function<bool()> setKey = [] { return false; };

  /// "Face 3 of Base"; brief: "Face 3" when only one shape is possible.
  [[nodiscard]] QString nameOf(const Value& subShape, bool brief = false) const;
};

/// One parameter in a form, made from its declaration: label, editor for its kind, and room for an error message. A drag
/// shows previews and ends as one edit; Esc cancels what is not an edit yet.
class ParameterField : public QWidget {
  Q_OBJECT
 public:
  using Context = std::shared_ptr<const FieldContext>;

  /// Creates the editor for the kind of the parameter.
  static ParameterField* make(const ParameterSpec&, QWidget* parent = nullptr, const Context& = nullptr);

  [[nodiscard]] const ParameterSpec& spec() const { return spec_; }
  /// Shows a value without emitting signals.
  void setValue(const Value&);
  [[nodiscard]] const Value& value() const { return value_; }
  /// The value as stored in the document, where an expression is kept as typed.
  [[nodiscard]] virtual Value written() const { return value_; }
  /// Sets the stored form; called before setValue with the value of the expression.
  virtual void setWritten(const Value&) {}
  /// The error message for the typed text, or that of the evaluation for this parameter.
  [[nodiscard]] QString problem() const;
  /// Sets an error message of the evaluation, shown until the value changes; empty: no error.
  void setFault(const QString&);
  /// Whether a drag or typed text is not an edit yet.
  [[nodiscard]] virtual bool editing() const { return previewing_; }
  /// Cancels a drag or typed text.
  void revert();
  /// Sets the value to a pick in the view. @returns whether the pick was suitable; otherwise the reason is shown below the
  /// editor.
  virtual bool takePick(const Pick&) { return false; }
  virtual void pickEnded() {}
  /// Shows the value anew, because other parts are lost.
  virtual void lostChanged() {}
  void resetToDefault();
  /// For fields in rows of a list: no label, and no reset to the default.
  virtual void hideLabel();
  /// Aligns the editor of a field in a group with those outside.
  void indentLabel(int pixels);

 signals:
  void previewed(const blossom::Value&);  ///< during a drag
  void edited(const blossom::Value&);     ///< checked and different from before
  void reverted();                        ///< the preview is cancelled
  void hint(const QString&);
  /// `field` will receive the pick; fields in lists and records prepend their path.
  void pickWanted(blossom::ui::ParameterField* field, const blossom::ui::PickRequest&);
  void pickUnwanted(blossom::ui::ParameterField* field);

 protected:
  ParameterField(ParameterSpec spec, Context context, QWidget* parent);
  void setEditor(QWidget*);
  /// Places the editor below the label with the width of the form, and `corner` to the right of the label.
  void setWideEditor(QWidget*, QWidget* corner = nullptr);
  /// Checks a value and emits it; for a wrong value a message is shown below the editor and the old value kept.
  void offer(const Value&, bool preview = false);
  void offerText(const QString&);
  void showProblem(const QString&);
  /// Forgets why what is typed in a line of the editor was refused, as soon as it is taken back there.
  void forgiveWhatIsTakenBack(QLineEdit*);
  /// Shows a line in a calm colour: the value of an expression.
  void showNote(const QString&);
  [[nodiscard]] FieldLabel& caption() const { return *caption_; }
  [[nodiscard]] const Context& context() const { return context_; }
  [[nodiscard]] const NamedNumbers& names() const { return context_->names; }
  virtual void display(const Value&) = 0;
  virtual void addToMenu(QMenu&) {}
  bool event(QEvent*) override;
  void enterEvent(QEnterEvent*) override;
  void leaveEvent(QEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;

 private:
  /// What is accepted, for the hint: a sentence, or nothing.
  [[nodiscard]] QString shownKind() const;
  void refreshMarks();
  [[nodiscard]] bool differsFromDefault() const;

  ParameterSpec spec_;
  Context context_;
  Value value_;
  bool previewing_ = false;
  bool refused_ = false;  ///< the problem is that of what is typed, not of the value
  bool labelled_ = true;
  QGridLayout* grid_;
  FieldLabel* caption_;
  QWidget* editor_ = nullptr;
  QWidget* corner_ = nullptr;
  QLabel* note_;
  QLabel* problem_;
  QToolButton* reset_;
};

/// The value as text with its unit, as shown in forms.
QString displayText(const ParameterSpec&, const Value&);
/// The value of typed text; lengths without a unit are in the preferred unit. @throws Error InvalidParameter.
Value parseTyped(const ParameterSpec&, const QString& text, const NamedNumbers&);
/// The name of a parameter as shown in forms; names of preferences are translated.
QString shownLabel(const ParameterSpec&);
/// The name of a choice as shown in forms.
QString shownChoice(const std::string&);

}  // namespace blossom::ui
