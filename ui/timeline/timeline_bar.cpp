#include "ui/timeline/timeline_bar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/controls/groove_slider.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/timeline/key_marks.h"
#include "ui/timeline/playback.h"

namespace blossom::ui {

namespace {

QToolButton* barButton(const QString& iconName, const QString& help, bool checkable = false) {
  auto* button = new QToolButton;
  button->setObjectName(iconName);
  button->setToolTip(help);
  button->setAccessibleName(help);
  button->setCheckable(checkable);
  button->setAutoRaise(true);
  button->setIconSize({18, 18});
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

}  // namespace

TimelineBar::TimelineBar(Playback& playback, QWidget* parent)
    : PassingBar(parent),
      playback_(playback),
      first_(barButton(QStringLiteral("first"), tr("First frame"))),
      back_(barButton(QStringLiteral("chevron-left"), tr("Frame before"))),
      play_(barButton(QStringLiteral("play"), tr("Play"))),
      forward_(barButton(QStringLiteral("chevron-right"), tr("Next frame"))),
      last_(barButton(QStringLiteral("last"), tr("Last frame"))),
      loop_(barButton(QStringLiteral("loop"), tr("Begin anew at the end"), true)),
      onion_(barButton(QStringLiteral("onion-skin"), tr("Onion skin: show the other frames faintly"), true)),
      key_(barButton(QStringLiteral("keyframe"), tr("Key at this frame"), true)),
      slider_(new GrooveSlider),
      marks_(new KeyMarks(*slider_)),
      frame_(new QLabel),
      pace_(new QComboBox) {
  setObjectName(QStringLiteral("timeline"));
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Timeline"));
  build();
  connectButtons();
  connect(&playback_, &Playback::changed, this, &TimelineBar::refresh);
  connect(&playback_, &Playback::moved, this, &TimelineBar::tellFrame);
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, &TimelineBar::refresh);
  refresh();
}

void TimelineBar::build() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(10, 6, 12, 6);
  row->setSpacing(2);
  for (QToolButton* button : {first_, back_, play_, forward_, last_}) row->addWidget(button);
  row->addSpacing(8);
  slider_->setAccessibleName(tr("Frame"));
  auto* column = new QVBoxLayout;
  column->setSpacing(0);
  column->addWidget(marks_);
  column->addWidget(slider_);
  row->addLayout(column, 1);
  row->addSpacing(8);
  frame_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(frame_);
  row->addSpacing(10);
  for (const int rate : {6, 12, 24, 30, 60}) pace_->addItem(tr("%1 frames/s").arg(rate), rate);
  pace_->setAccessibleName(tr("Pace"));
  pace_->setToolTip(tr("How fast it plays"));
  row->addWidget(pace_);
  row->addSpacing(4);
  row->addWidget(key_);
  row->addWidget(loop_);
  row->addWidget(onion_);
}

void TimelineBar::connectButtons() {
  connect(first_, &QToolButton::clicked, this, [this] { playback_.show(0); });
  connect(back_, &QToolButton::clicked, this, [this] { playback_.show(playback_.frame() - 1); });
  connect(forward_, &QToolButton::clicked, this, [this] { playback_.show(playback_.frame() + 1); });
  connect(last_, &QToolButton::clicked, this, [this] { playback_.show(playback_.count() - 1); });
  connect(play_, &QToolButton::clicked, this, [this] { playback_.setPlaying(!playback_.playing()); });
  connect(loop_, &QToolButton::toggled, &playback_, &Playback::setLooping);
  connect(onion_, &QToolButton::toggled, &playback_, &Playback::setOnionSkin);
  connect(key_, &QToolButton::clicked, this, [this](bool on) {
    if (on)
      emit keyWanted(keyFrame());
    else
      emit keyUnwanted(keyFrame());
  });
  connect(slider_, &QSlider::valueChanged, this, [this](int frame) {
    playback_.setPlaying(false);  // who scrubs wants to look
    playback_.show(frame);
  });
  connect(pace_, &QComboBox::activated, this,
          [this](int row) { playback_.setFramesPerSecond(pace_->itemData(row).toInt()); });
}

void TimelineBar::refresh() {
  for (QToolButton* button : {first_, back_, forward_, last_, loop_, onion_, key_})
    button->setIcon(icon(button->objectName()));
  play_->setIcon(icon(playback_.playing() ? QStringLiteral("pause") : QStringLiteral("play")));
  const bool frames = playback_.count() > 1;
  for (QWidget* each : std::initializer_list<QWidget*>{first_, back_, forward_, last_, loop_, onion_, slider_, pace_})
    each->setEnabled(frames);
  play_->setToolTip(playback_.playing() ? tr("Pause") : frames ? tr("Play") : tr("Play: makes a sequence of frames first"));
  play_->setAccessibleName(play_->toolTip());
  const QSignalBlocker quietSlider(slider_), quietLoop(loop_), quietOnion(onion_);
  slider_->setRange(0, qMax(0, playback_.count() - 1));
  slider_->setPageStep(qMax(1, playback_.count() / 10));
  loop_->setChecked(playback_.looping());
  onion_->setChecked(playback_.onionSkin());
  if (const int row = pace_->findData(playback_.framesPerSecond()); row >= 0) pace_->setCurrentIndex(row);
  // As wide as the longest it will say, so that nothing moves while it plays.
  frame_->setMinimumWidth(
      frame_->fontMetrics().horizontalAdvance(tr("%1 of %2").arg(playback_.count()).arg(playback_.count())));
  tellFrame();
}

void TimelineBar::setKeys(std::optional<TimelineKeys> keys) {
  keys_ = std::move(keys);
  if (keys_) marks_->setKeys(keys_->frames, keys_->count);
  refreshKeys();
}

int TimelineBar::keyFrame() const { return playback_.frameOf(keys_ ? keys_->count : 1) + 1; }

void TimelineBar::refreshKeys() {
  marks_->setVisible(keys_.has_value());
  key_->setVisible(keys_.has_value());
  key_->setChecked(keys_ && std::find(keys_->frames.begin(), keys_->frames.end(), keyFrame()) != keys_->frames.end());
}

void TimelineBar::tellFrame() {
  refreshKeys();
  const QSignalBlocker quiet(slider_);
  slider_->setValue(playback_.frame());
  frame_->setText(playback_.count() > 1 ? tr("%1 of %2").arg(playback_.frame() + 1).arg(playback_.count()) : QString());
}

}  // namespace blossom::ui
