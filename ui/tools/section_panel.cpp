#include "ui/tools/section_panel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "ui/controls/groove_slider.h"
#include "ui/look/icons.h"
#include "ui/look/restyle.h"
#include "ui/look/text.h"
#include "ui/look/units.h"

namespace blossom::ui {

namespace {

constexpr int sliderSteps = 1000;

}  // namespace

SectionPanel::SectionPanel(QWidget* view)
    : FloatingPanel(view, Place::Bottom),
      axes_(new QButtonGroup(this)),
      offset_(new QLineEdit),
      slider_(new GrooveSlider),
      flip_(textButton(tr("Flip"), tr("Cut away the other side (F)"))),
      off_(textButton(tr("Off"), tr("Show everything whole again (Del)"))),
      problem_(new QLabel) {
  setAccessibleName(tr("Section"));
  build();
  connect(axes_, &QButtonGroup::idClicked, this, [this](int id) { emit axisChosen(static_cast<SectionAxis>(id)); });
  connect(offset_, &QLineEdit::editingFinished, this, &SectionPanel::type);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int step) { emit offsetChosen(range_.first + (range_.second - range_.first) * step / sliderSteps); });
  connect(flip_, &QToolButton::clicked, this, &SectionPanel::flipped);
  connect(off_, &QToolButton::clicked, this, &SectionPanel::turnedOff);
}

void SectionPanel::build() {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const std::pair<QString, QString> choices[] = {{QStringLiteral("X"), tr("Across the x axis (X)")},
                                                 {QStringLiteral("Y"), tr("Across the y axis (Y)")},
                                                 {QStringLiteral("Z"), tr("Across the z axis (Z)")},
                                                 {tr("Face"), tr("Parallel to a face that you pick (P)")}};
  int id = 0;
  for (const auto& [text, help] : choices) {
    QToolButton* choice = textButton(text, help);
    choice->setCheckable(true);
    axes_->addButton(choice, id++);
    row->addWidget(choice);
  }
  slider_->setRange(0, sliderSteps);
  slider_->setPageStep(sliderSteps / 20);
  slider_->setFixedWidth(180);
  slider_->setAccessibleName(tr("Offset of the section"));
  offset_->setFixedWidth(offset_->fontMetrics().horizontalAdvance(QStringLiteral("-0000.00000 mm")) + 24);
  offset_->setAlignment(Qt::AlignRight);
  offset_->setAccessibleName(tr("Offset of the section"));
  offset_->setToolTip(tr("Where it cuts, such as 12.5 or 1/2 in"));
  row->addSpacing(6);
  row->addWidget(slider_);
  row->addWidget(offset_);
  row->addSpacing(6);
  row->addWidget(flip_);
  row->addWidget(off_);
  problem_->setObjectName(QStringLiteral("fieldError"));
  problem_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(4);
  column->addLayout(row);
  column->addWidget(problem_);
}

void SectionPanel::show(const SectionPlane& plane, std::pair<double, double> range, bool pickingFace) {
  range_ = range;
  shown_ = plane.offset();
  axes_->button(static_cast<int>(pickingFace ? SectionAxis::Face : plane.axis()))->setChecked(true);
  const double width = range.second - range.first;
  const double share = width > 0 ? std::clamp((plane.offset() - range.first) / width, 0.0, 1.0) : 0;
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(share * sliderSteps)));
  // The field is not written over while it is typed in.
  if (!offset_->hasFocus() || !offset_->isModified()) offset_->setText(readableLength(plane.offset()));
  FloatingPanel::show();
}

void SectionPanel::type() {
  if (!offset_->isModified()) return;
  offset_->setModified(false);
  QString text = offset_->text();
  text.remove(QChar(0x2009)).replace(QChar(0x2212), u'-');
  try {
    const double value = parseLength(text.toStdString(), lengthUnit());
    restyle(offset_, "wrong", false);
    problem_->hide();
    emit offsetChosen(value);
  } catch (const Error& error) {
    restyle(offset_, "wrong", true);
    problem_->setText(qt(error.message()));
    problem_->show();
    offset_->setText(readableLength(shown_));
  }
  settle();
}

}  // namespace blossom::ui
