#include "ui/fields/color_field.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QLineEdit>

#include "ui/controls/swatch.h"
#include "ui/controls/window_keys.h"
#include "ui/look/text.h"

namespace blossom::ui {

ColorField::ColorField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), swatch_(new Swatch), line_(new QLineEdit) {
  leaveKeysToTheWindow(line_);
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(swatch_);
  row->addWidget(line_, 1);
  line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  line_->setPlaceholderText(given.mayBeAbsent ? tr("none") : tr("must be given"));
  setEditor(both);
  both->setFocusProxy(line_);
  forgiveWhatIsTakenBack(line_);
  connect(swatch_, &QAbstractButton::clicked, this, &ColorField::choose);
  connect(line_, &QLineEdit::editingFinished, this, [this] {
    if (!line_->isModified()) return;
    // "orange" is a colour as well.
    const QColor named(line_->text().trimmed().toLower().remove(u' '));
    offerText(!line_->text().contains(u'#') && named.isValid() ? named.name() : line_->text());
  });
}

bool ColorField::editing() const { return ParameterField::editing() || line_->isModified(); }

void ColorField::display(const Value& shown) {
  const QString text = shown.is_string() ? qt(shown.get<std::string>()) : QString();
  line_->setText(text);
  swatch_->setColor(text.isEmpty() ? QColor() : QColor(text));
}

void ColorField::choose() {
  if (dialog_) return dialog_->raise();
  dialog_ = new QColorDialog(swatch_->color().isValid() ? swatch_->color() : QColor(Qt::white), this);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  dialog_->setOption(QColorDialog::DontUseNativeDialog);
  dialog_->setWindowTitle(shownLabel(spec()));
  connect(dialog_, &QColorDialog::currentColorChanged, this, [this](const QColor& color) {
    swatch_->setColor(color);
    offer(color.name().toStdString(), true);
  });
  connect(dialog_, &QColorDialog::colorSelected, this, [this](const QColor& color) { offer(color.name().toStdString()); });
  connect(dialog_, &QColorDialog::rejected, this, [this] { revert(); });
  dialog_->open();
}

}  // namespace blossom::ui
