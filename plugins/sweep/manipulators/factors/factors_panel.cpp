#include "manipulators/factors/factors_panel.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "manipulators/factors/comb_plot.h"
#include "manipulators/factors/turn_ball.h"
#include "ui/controls/number_line.h"
#include "ui/look/icons.h"
#include "ui/look/restyle.h"

namespace blossom::sweep {

namespace {

constexpr int panelWidth = 364;  // the row of buttons at the foot has room in every language

}  // namespace

FactorsPanel::FactorsPanel(QWidget* view)
    : FloatingPanel(view, Place::UpperLeft),
      factors_(new QButtonGroup(this)),
      directions_(new QButtonGroup(this)),
      net_(new FactorNet),
      plot_(new CombPlot),
      ball_(new TurnBall),
      turning_(new QWidget),
      turn_(new QPushButton(tr("Turn"))),
      set_(new QPushButton(tr("Set"))),
      frames_(checkButton(tr("Frames"), tr("Draw the frames M(u, v) along u and v"))),
      iso_(checkButton(tr("Iso-curves"), tr("Draw the curves of constant u and v at the knots"))),
      combs_(checkButton(tr("Comb"), tr("Draw the curvature comb of the trajectory"))),
      summary_(new QLabel),
      problem_(new QLabel) {
  setAccessibleName(tr("Factors"));
  build();
  connect(factors_, &QButtonGroup::idClicked, this, [this](int id) { emit factorChosen(static_cast<Factor>(id)); });
  connect(directions_, &QButtonGroup::idClicked, this, &FactorsPanel::displayChosen);
  connect(turn_, &QPushButton::clicked, this, [this] { emit turnWanted(false); });
  connect(set_, &QPushButton::clicked, this, [this] { emit turnWanted(true); });
  for (QToolButton* each : {frames_, iso_, combs_}) connect(each, &QToolButton::clicked, this, &FactorsPanel::displayChosen);
  setFactor(factor_);
}

QToolButton* FactorsPanel::checkButton(const QString& text, const QString& help) {
  QToolButton* const made = textButton(text, help);
  made->setAccessibleName(text);
  made->setCheckable(true);
  return made;
}

void FactorsPanel::build() {
  setFixedWidth(panelWidth);
  summary_->setObjectName(QStringLiteral("note"));
  problem_->setObjectName(QStringLiteral("fieldError"));
  problem_->setWordWrap(true);
  problem_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 10);
  column->setSpacing(6);
  column->addLayout(factorRow());
  column->addWidget(net_);
  column->addWidget(summary_);
  column->addLayout(fieldGrid());
  turning_->setLayout(turnRow());
  column->addWidget(turning_);
  column->addWidget(problem_);
  column->addWidget(plot_);
  column->addLayout(displayRow());
}

QHBoxLayout* FactorsPanel::factorRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const std::pair<Factor, QString> all[] = {
      {Factor::Trajectory, tr("Trajectory")}, {Factor::Orientation, tr("Orientation")}, {Factor::Scaling, tr("Scaling")}};
  for (const auto& [factor, text] : all) {
    QToolButton* button = checkButton(text, tr("Edit the poles of this factor"));
    factors_->addButton(button, static_cast<int>(factor));
    row->addWidget(button);
  }
  row->addStretch(1);
  auto* const close = textButton({}, tr("Close the card"));
  close->setObjectName(QStringLiteral("closeCard"));
  close->setIcon(ui::icon(QStringLiteral("close")));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, &FactorsPanel::closeWanted);
  row->addWidget(close);
  return row;
}

QGridLayout* FactorsPanel::fieldGrid() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  for (int k = 0; k < fieldCount; ++k) {
    const auto i = static_cast<std::size_t>(k);
    names_[i] = checkButton({}, {});
    names_[i]->setChecked(true);
    names_[i]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    fields_[i] = new ui::NumberLine;
    fields_[i]->setProperty("tight", true);
    fields_[i]->setAlignment(Qt::AlignRight);
    fields_[i]->setObjectName(QStringLiteral("factorField%1").arg(k));
    grid->addWidget(names_[i], 0, k);
    grid->addWidget(fields_[i], 1, k);
    connect(fields_[i], &QLineEdit::returnPressed, this, [this, k] {
      fields_[static_cast<std::size_t>(k)]->setModified(true);  // once more, though it is the same number
    });
    connect(fields_[i], &QLineEdit::editingFinished, this, [this, k] { enter(k); });
  }
  return grid;
}

QHBoxLayout* FactorsPanel::turnRow() {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(ball_);
  auto* buttons = new QVBoxLayout;
  turn_->setToolTip(tr("Turn the chosen poles about the axis by the angle"));
  set_->setToolTip(tr("Give the chosen poles this turn from the fixed axes"));
  buttons->addStretch(1);
  for (QPushButton* each : {turn_, set_}) {
    each->setAutoDefault(false);
    buttons->addWidget(each);
  }
  buttons->addStretch(1);
  row->addLayout(buttons, 1);
  return row;
}

QHBoxLayout* FactorsPanel::displayRow() {
  auto* row = new QHBoxLayout;
  row->setSpacing(2);
  const std::pair<QString, QString> along[] = {{tr("Along u"), tr("The comb along u through the chosen pole")},
                                               {tr("Along v"), tr("The comb along v through the chosen pole")}};
  int id = 0;
  for (const auto& [text, help] : along) {
    QToolButton* button = checkButton(text, help);
    directions_->addButton(button, id++);
    row->addWidget(button);
  }
  directions_->button(1)->setChecked(true);
  row->addStretch(1);
  combs_->setChecked(true);
  for (QToolButton* each : {combs_, frames_, iso_}) row->addWidget(each);
  return row;
}

void FactorsPanel::setFactor(Factor factor) {
  factor_ = factor;
  factors_->button(static_cast<int>(factor))->setChecked(true);
  labelFields(factor);
  turning_->setVisible(factor == Factor::Orientation);
  combs_->setVisible(factor == Factor::Trajectory);
  for (QAbstractButton* each : directions_->buttons()) each->setVisible(factor != Factor::Trajectory);
  forgive();
  settle();
}

void FactorsPanel::labelFields(Factor factor) {
  const QString letters[] = {QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (int k = 0; k < fieldCount; ++k) {
    QToolButton* const name = names_[static_cast<std::size_t>(k)];
    const bool coordinate = k + 1 < fieldCount;
    const QString text = coordinate ? letters[k] : factor == Factor::Orientation ? tr("Angle") : tr("Weight");
    name->setText(coordinate && factor == Factor::Orientation ? tr("Axis %1").arg(text) : text);
    name->setAccessibleName(name->text());
    // Only of the scaling is there a choice.
    const bool choice = coordinate && factor == Factor::Scaling;
    name->setCheckable(choice);
    name->setAttribute(Qt::WA_TransparentForMouseEvents, !choice);
    name->setFocusPolicy(choice ? Qt::StrongFocus : Qt::NoFocus);
    if (choice) name->setChecked(true);
    name->setToolTip(choice ? tr("A drag in the net scales along this axis") : QString());
    QLineEdit* const field = fields_[static_cast<std::size_t>(k)];
    field->setAccessibleName(name->text());
    field->setModified(false);
    field->clear();
  }
  if (factor != Factor::Orientation) return;
  const QString start[] = {QStringLiteral("0"), QStringLiteral("0"), QStringLiteral("1"), QStringLiteral("15")};
  for (int k = 0; k < fieldCount; ++k) fields_[static_cast<std::size_t>(k)]->setText(start[k]);
}

void FactorsPanel::setValues(const Texts& texts, bool editable) {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    QLineEdit* const field = fields_[k];
    field->setEnabled(editable || factor_ == Factor::Orientation);
    if (factor_ == Factor::Orientation) continue;
    known_[k] = texts[k];
    const bool typing = field->hasFocus() && field->isModified();
    if (!typing && !isRefused(*field)) showKnown(k);
  }
  for (QWidget* each : std::initializer_list<QWidget*>{turn_, set_, ball_}) each->setEnabled(editable);
}

void FactorsPanel::showKnown(std::size_t field) {
  QLineEdit& line = *fields_[field];
  if (line.text() == known_[field]) return;
  line.setText(known_[field]);
  line.setCursorPosition(0);
}

/// What was refused stays in its field, beside the reason.
bool FactorsPanel::isRefused(const QLineEdit& field) { return field.property("wrong").toBool(); }

void FactorsPanel::setSummary(const QString& summary) {
  if (summary_->text() != summary) summary_->setText(summary);
}

void FactorsPanel::enter(int field) {
  QLineEdit* const line = fields_[static_cast<std::size_t>(field)];
  if (!line->isModified()) return;
  forgive();
  line->setModified(false);
  emit typed(field, line->text());
}

/// The field that is being typed in; nullptr: none.
QLineEdit* FactorsPanel::fieldOfTyping() const {
  const auto typing = [](const QLineEdit* field) { return field->hasFocus() && field->isModified(); };
  const auto found = std::find_if(fields_.begin(), fields_.end(), typing);
  return found == fields_.end() ? nullptr : *found;
}

void FactorsPanel::takeBackTyping() {
  if (QLineEdit* const field = fieldOfTyping()) {
    while (field->isUndoAvailable()) field->undo();
    field->setModified(false);
    field->selectAll();
  }
  forgive();
}

// Esc comes by here when a field leaves it, and is asked for before the window ends the tool by it.
bool FactorsPanel::event(QEvent* event) {
  const bool pressed = event->type() == QEvent::KeyPress;
  if (!pressed && event->type() != QEvent::ShortcutOverride) return FloatingPanel::event(event);
  const bool escape = static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape;
  if (!escape || !(fieldOfTyping() || problem_->isVisible())) return FloatingPanel::event(event);
  if (pressed) takeBackTyping();
  event->accept();
  return true;
}

void FactorsPanel::refuse(int field, const QString& why) {
  if (field >= 0) ui::restyle(fields_[static_cast<std::size_t>(field)], "wrong", true);
  problem_->setText(why);
  problem_->show();
  settle();
}

void FactorsPanel::forgive() {
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    QLineEdit& line = *fields_[k];
    if (isRefused(line) && factor_ != Factor::Orientation && !line.isModified()) showKnown(k);
    ui::restyle(&line, "wrong", false);
  }
  if (problem_->isHidden()) return;
  problem_->hide();
  settle();
}

bool FactorsPanel::alongU() const { return directions_->checkedId() == 0; }

std::array<bool, 3> FactorsPanel::scaled() const {
  return {names_[0]->isChecked(), names_[1]->isChecked(), names_[2]->isChecked()};
}

bool FactorsPanel::showsFrames() const { return frames_->isChecked(); }
bool FactorsPanel::showsIsoCurves() const { return iso_->isChecked(); }
bool FactorsPanel::showsCombs() const { return combs_->isChecked(); }
QString FactorsPanel::text(int field) const { return fields_[static_cast<std::size_t>(field)]->text(); }

}  // namespace blossom::sweep
