#include "manipulators/morph_card.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "manipulators/influence_chart.h"
#include "manipulators/path_pad.h"

namespace blossom::minkowski {

MorphCard::MorphCard(QWidget* view)
    : FloatingPanel(view, Place::UpperLeft),
      figures_(new QLabel),
      note_(new QLabel),
      ladder_(textButton(tr("Ladder"), tr("Draw the shapes between the control shapes and this one (L)"))),
      influences_(textButton(tr("Influence"), tr("Draw how much each control shape counts over t"))),
      path_(textButton(tr("Path"), tr("Draw the way of the sequence through the blossom"))),
      head_(new QBoxLayout(QBoxLayout::LeftToRight)),
      chart_(new InfluenceChart),
      pad_(new PathPad) {
  setAccessibleName(tr("Morph"));
  ladder_->setObjectName(QStringLiteral("ladder"));
  influences_->setObjectName(QStringLiteral("influences"));
  path_->setObjectName(QStringLiteral("path"));
  for (QToolButton* button : {ladder_, influences_, path_}) {
    button->setAccessibleName(button->text());
    button->setCheckable(true);
  }
  chart_->hide();
  pad_->hide();
  figures_->setObjectName(QStringLiteral("morphFigures"));
  note_->setObjectName(QStringLiteral("note"));
  for (QLabel* label : {figures_, note_}) label->hide();
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(ladder_);
  row->addWidget(influences_);
  row->addWidget(path_);
  row->addStretch();
  head_->setSpacing(10);
  head_->addLayout(row);
  head_->addWidget(figures_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 8);
  column->setSpacing(4);
  column->addLayout(head_);
  column->addWidget(chart_, 0, Qt::AlignLeft);
  column->addWidget(pad_, 0, Qt::AlignLeft);
  column->addWidget(note_);
  connect(ladder_, &QToolButton::clicked, this, &MorphCard::ladderWanted);
  connect(influences_, &QToolButton::clicked, this, &MorphCard::influencesWanted);
  connect(path_, &QToolButton::clicked, this, &MorphCard::pathWanted);
}

void MorphCard::tell(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
  if (label->isHidden() != text.isEmpty()) label->setHidden(text.isEmpty());
}

void MorphCard::setFigures(const QString& text) { tell(figures_, text); }

void MorphCard::setLadder(bool on) { ladder_->setChecked(on); }

void MorphCard::setInfluences(bool on, bool possible) {
  influences_->setChecked(on);
  if (chart_->isHidden() == possible) chart_->setHidden(!possible);
  arrange();
}

void MorphCard::setPath(bool open, bool possible) {
  path_->setChecked(open);
  if (pad_->isHidden() == (open && possible)) pad_->setVisible(open && possible);
  arrange();
}

// The card hides no more of the drawing than it must: it is as wide as the chart or the pad, or as low as one row.
void MorphCard::arrange() {
  const bool isLow = chart_->isHidden() && pad_->isHidden();
  head_->setDirection(isLow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  head_->setSpacing(isLow ? 10 : 4);
}

void MorphCard::setNote(const QString& text) { tell(note_, text); }

}  // namespace blossom::minkowski
