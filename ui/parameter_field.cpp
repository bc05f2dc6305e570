#include "ui/parameter_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>

#include "core/error.h"
#include "ui/ratio_slider.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

constexpr int labelWidth = 92;

// The name stands beside the field already.
QString reason(const ParameterSpec& spec, const Error& error) {
  QString text = qt(error.message());
  const QString name = qt(spec.name) + QStringLiteral(": ");
  if (text.startsWith(name)) text.remove(0, name.size());
  return sentenceCase(text);
}

class FlagField final : public ParameterField {
 public:
  FlagField(const ParameterSpec& spec, QWidget* parent) : ParameterField(spec, parent), box_(new QCheckBox) {
    setEditor(box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool on) { offer(on); });
  }

 private:
  void display(const Value& value) override {
    const bool on = value.is_boolean() && value.get<bool>();
    box_->setChecked(on);
    box_->setText(on ? tr("on") : tr("off"));
  }
  QCheckBox* box_;
};

class ChoiceField final : public ParameterField {
 public:
  ChoiceField(const ParameterSpec& given, QWidget* parent) : ParameterField(given, parent), box_(new QComboBox) {
    for (const std::string& name : given.choices) box_->addItem(qt(name));
    box_->setFocusPolicy(Qt::StrongFocus);
    setEditor(box_);
    connect(box_, &QComboBox::activated, this, [this](int index) { offer(box_->itemText(index).toStdString()); });
  }

 private:
  void display(const Value& value) override {
    if (value.is_string()) box_->setCurrentText(qt(value.get<std::string>()));
  }
  QComboBox* box_;
};

class RatioField final : public ParameterField {
 public:
  RatioField(const ParameterSpec& given, QWidget* parent) : ParameterField(given, parent), slider_(new RatioSlider) {
    setEditor(slider_);
    connect(slider_, &RatioSlider::dragged, this, [this](double t) { offer(t, true); });
    connect(slider_, &RatioSlider::chosen, this, [this](double t) { offer(t); });
    connect(slider_, &RatioSlider::typed, this, [this](const QString& text) { offerText(text); });
  }

 private:
  void display(const Value& value) override {
    if (value.is_number()) slider_->setValue(value.get<double>());
  }
  RatioSlider* slider_;
};

/// Everything that is written: numbers, lengths, angles, texts, points, lists.
class TextField : public ParameterField {
 public:
  TextField(const ParameterSpec& given, QWidget* parent) : ParameterField(given, parent), line_(new QLineEdit) {
    setEditor(line_);
    connect(line_, &QLineEdit::editingFinished, this, [this] {
      if (line_->isModified())
        offerText(line_->text());
      else
        display(value());
    });
  }

 protected:
  void display(const Value& shown) override { line_->setText(displayText(spec(), shown)); }
  QLineEdit* line_;
};

class FileField final : public TextField {
 public:
  FileField(const ParameterSpec& given, QWidget* parent) : TextField(given, parent) {
    line_->setReadOnly(true);
    line_->setToolTip(tr("The file; its content is kept in the document."));
  }
};

QString unitOf(const ParameterSpec& spec) {
  if (spec.kind == ParameterKind::Length) return QStringLiteral(" mm");
  if (spec.kind == ParameterKind::Angle) return QStringLiteral("°");
  return {};
}

}  // namespace

QString displayText(const ParameterSpec& spec, const Value& value) {
  if (value.is_null()) return {};
  if (spec.kind == ParameterKind::File && value.is_object()) {
    const QString path = qt(value.value("path", std::string()));
    return path.section(u'/', -1);
  }
  const QString text = qt(formatText(spec, value));
  return value.is_number() && !text.isEmpty() && (text.back().isDigit() || text.back() == u'.') ? text + unitOf(spec) : text;
}

ParameterField* ParameterField::make(const ParameterSpec& spec, QWidget* parent) {
  switch (spec.kind) {
    case ParameterKind::Flag:
      return new FlagField(spec, parent);
    case ParameterKind::Choice:
      return new ChoiceField(spec, parent);
    case ParameterKind::Ratio:
      return new RatioField(spec, parent);
    case ParameterKind::File:
      return new FileField(spec, parent);
    default:
      return new TextField(spec, parent);
  }
}

ParameterField::ParameterField(ParameterSpec spec, QWidget* parent)
    : QWidget(parent), spec_(std::move(spec)), problem_(new QLabel), grid_(new QGridLayout(this)) {
  const QString name = sentenceCase(qt(label(spec_)));
  auto* title = new QLabel(name);
  title->setObjectName(QStringLiteral("fieldLabel"));
  title->setFixedWidth(labelWidth);
  title->setWordWrap(true);
  problem_->setObjectName(QStringLiteral("fieldError"));
  problem_->setWordWrap(true);
  problem_->hide();
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->addWidget(title, 0, 0);
  grid_->addWidget(problem_, 1, 0, 1, 2);
  grid_->setColumnStretch(1, 1);
  setToolTip(qt(spec_.help));
  setObjectName(QStringLiteral("parameter:") + qt(spec_.name));
}

void ParameterField::setEditor(QWidget* editor) {
  editor->setAccessibleName(sentenceCase(qt(label(spec_))));
  editor->setAccessibleDescription(qt(spec_.help));
  grid_->addWidget(editor, 0, 1);
}

void ParameterField::setValue(const Value& value) {
  value_ = value;
  showProblem({});
  display(value_);
}

QString ParameterField::problem() const { return problem_->isHidden() ? QString() : problem_->text(); }

void ParameterField::showProblem(const QString& text) {
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
  if (QWidget* editor = grid_->itemAtPosition(0, 1) ? grid_->itemAtPosition(0, 1)->widget() : nullptr) {
    editor->setProperty("wrong", !text.isEmpty());
    editor->style()->unpolish(editor);
    editor->style()->polish(editor);
  }
}

void ParameterField::offer(const Value& wanted, bool preview) {
  try {
    const Value good = checked(spec_, wanted);
    showProblem({});
    if (preview) {
      emit previewed(good);
      return;
    }
    const bool changed = good != value_;
    value_ = good;
    display(value_);
    if (changed) emit edited(value_);
  } catch (const Error& error) {
    showProblem(reason(spec_, error) + tr(" The value before is kept."));
  }
}

void ParameterField::offerText(const QString& text) {
  try {
    offer(parseText(spec_, text.trimmed().toStdString()));
  } catch (const Error& error) {
    showProblem(reason(spec_, error) + tr(" The value before is kept."));
  }
}

void ParameterField::enterEvent(QEnterEvent*) {
  emit hint(QStringLiteral("%1: %2 %3")
                .arg(sentenceCase(qt(label(spec_))), qt(spec_.help), sentenceCase(qt(describe(spec_))) + u'.'));
}

}  // namespace blossom::ui
