#include "ui/look/restyle.h"

#include <QStyle>
#include <QVariant>
#include <QWidget>

namespace blossom::ui {

void restyle(QWidget* widget, const char* property, bool on) {
  if (widget->property(property).toBool() == on) return;
  widget->setProperty(property, on);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

}  // namespace blossom::ui
