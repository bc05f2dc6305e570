#include "ui/fields/simple_fields.h"

#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <algorithm>

#include "ui/controls/ratio_slider.h"
#include "ui/controls/switch_box.h"
#include "ui/controls/wheel_gesture.h"
#include "ui/controls/window_keys.h"
#include "ui/look/text.h"

namespace blossom::ui {

FlagField::FlagField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), box_(new SwitchBox) {
  setEditor(box_);
  connect(box_, &QCheckBox::clicked, this, [this](bool on) { offer(on); });
}

void FlagField::display(const Value& shown) { box_->setChecked(shown.is_boolean() && shown.get<bool>()); }

ChoiceField::ChoiceField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), box_(new QComboBox) {
  for (const std::string& name : given.choices) box_->addItem(shownChoice(name), qt(name));
  if (given.mayBeAbsent) box_->insertItem(0, tr("none"));
  box_->setPlaceholderText(tr("must be given"));
  box_->setFocusPolicy(Qt::StrongFocus);
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setMinimumContentsLength(3);
  box_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  box_->installEventFilter(this);
  watchWheel();
  setEditor(box_);
  connect(box_, &QComboBox::activated, this, [this](int index) {
    const QVariant name = box_->itemData(index);
    offer(name.isValid() ? Value(name.toString().toStdString()) : Value());
  });
}

void ChoiceField::display(const Value& shown) {
  if (shown.is_string())
    box_->setCurrentIndex(box_->findData(qt(shown.get<std::string>())));
  else
    box_->setCurrentIndex(spec().mayBeAbsent ? 0 : -1);
}

// The wheel scrolls the panel unless the turn began on the box that was chosen.
bool ChoiceField::eventFilter(QObject* object, QEvent* event) {
  if (object == box_ && event->type() == QEvent::Wheel && !wheelMeans(*box_)) {
    event->ignore();
    return true;
  }
  return ParameterField::eventFilter(object, event);
}

RatioField::RatioField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), slider_(new RatioSlider) {
  // What a parameter takes beyond 0 and 1 can be typed.
  slider_->setRange(std::max(given.minimum.value_or(0), 0.0), std::min(given.maximum.value_or(1), 1.0));
  setEditor(slider_);
  connect(slider_, &RatioSlider::dragged, this, [this](double t) { offer(t, true); });
  connect(slider_, &RatioSlider::chosen, this, [this](double t) { offer(t); });
  connect(slider_, &RatioSlider::takenBack, this, &RatioField::revert);
  connect(slider_, &RatioSlider::typed, this, [this](const QString& text) { offerText(text); });
}

bool RatioField::editing() const { return ParameterField::editing() || slider_->typing(); }

void RatioField::display(const Value& shown) {
  slider_->setAbsent(!shown.is_number());
  slider_->setValue(shown.is_number() ? shown.get<double>() : spec().minimum.value_or(0));
}

TextField::TextField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), line_(new QLineEdit) {
  leaveKeysToTheWindow(line_);
  line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  line_->setPlaceholderText(given.mayBeAbsent ? tr("none") : QString());
  setEditor(line_);
  forgiveWhatIsTakenBack(line_);
  // A text is taken as it is written, with blanks at its ends.
  connect(line_, &QLineEdit::editingFinished, this, [this] {
    if (!line_->isModified()) return;
    const bool absent = spec().mayBeAbsent && line_->text().isEmpty();
    offer(absent ? Value() : Value(line_->text().toStdString()));
  });
}

bool TextField::editing() const { return line_->isModified(); }

void TextField::display(const Value& shown) {
  line_->setText(shown.is_string() ? qt(shown.get<std::string>()) : QString());
  line_->setCursorPosition(0);
}

}  // namespace blossom::ui
