#include "ui/numbers/numbers_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/error.h"
#include "ui/look/text.h"
#include "ui/look/units.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

enum Column { Name, Written, Result, Columns };

/// "60 mm", "2400 mm²", "30°", "5"; lengths in the unit that the user prefers.
QString shown(const Dimensioned& value) {
  const auto number = [](double each) { return QString::number(each, 'g', 12); };
  const LengthUnit& unit = lengthUnit();
  if (value.is(1, 0)) return number(value.value / unit.millimetres) + u' ' + qt(unit.name);
  if (value.is(2, 0)) return number(value.value / (unit.millimetres * unit.millimetres)) + u' ' + qt(unit.name) + u'²';
  return number(value.value) + (value.is(0, 1) ? QStringLiteral("°") : QString());
}

}  // namespace

NumbersDialog::NumbersDialog(Session& session, QWidget* parent)
    : QDialog(parent), session_(session), table_(new QTableWidget(0, Columns)), problem_(new QLabel) {
  setWindowTitle(tr("Named numbers"));
  auto* layout = new QVBoxLayout(this);
  auto* about =
      new QLabel(tr("A name can be used in every field of this document, as in width/2 + 3 mm. A value without a unit is a "
                    "plain number."));
  about->setWordWrap(true);
  layout->addWidget(about);
  table_->setHorizontalHeaderLabels({tr("Name"), tr("Value"), tr("Comes to")});
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->hide();
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAccessibleName(windowTitle());
  layout->addWidget(table_, 1);
  problem_->setObjectName(QStringLiteral("fieldError"));
  problem_->setWordWrap(true);
  layout->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QPushButton* remove = buttons->addButton(tr("Remove row"), QDialogButtonBox::ActionRole);
  remove->setObjectName(QStringLiteral("removeRow"));
  ok_ = buttons->button(QDialogButtonBox::Ok);
  layout->addWidget(buttons);
  connect(remove, &QPushButton::clicked, this, &NumbersDialog::removeRow);
  connect(buttons, &QDialogButtonBox::accepted, this, &NumbersDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &NumbersDialog::reject);
  for (const NamedNumber& row : numbersOf(session.document())) addRow(qt(row.name), qt(row.name), qt(row.value));
  addRow({}, {}, {});
  connect(table_, &QTableWidget::itemChanged, this, [this](const QTableWidgetItem* item) {
    if (item->column() != Result) refresh();
  });
  refresh();
  resize(520, 360);
}

void NumbersDialog::addRow(const QString& before, const QString& name, const QString& value) {
  const QSignalBlocker whole(table_);  // a row is looked at when all of it is there
  const int row = table_->rowCount();
  table_->insertRow(row);
  auto* named = new QTableWidgetItem(name);
  named->setData(Qt::UserRole, before);
  table_->setItem(row, Name, named);
  table_->setItem(row, Written, new QTableWidgetItem(value));
  auto* result = new QTableWidgetItem;
  result->setFlags(Qt::ItemIsEnabled);
  table_->setItem(row, Result, result);
}

void NumbersDialog::removeRow() {
  if (table_->currentRow() >= 0) table_->removeRow(table_->currentRow());
  refresh();
}

std::vector<NumbersDialog::Row> NumbersDialog::rows() const {
  std::vector<Row> all;
  for (int k = 0; k < table_->rowCount(); ++k) {
    const QString name = table_->item(k, Name)->text().trimmed(), value = table_->item(k, Written)->text().trimmed();
    if (!name.isEmpty() || !value.isEmpty())
      all.push_back({table_->item(k, Name)->data(Qt::UserRole).toString(), {name.toStdString(), value.toStdString()}});
  }
  return all;
}

std::vector<NamedNumber> NumbersDialog::tableOf(const std::vector<Row>& rows) {
  std::vector<NamedNumber> table;
  table.reserve(rows.size());
  for (const Row& row : rows) table.push_back(row.now);
  return table;
}

// A number that has got another name keeps its places; then the values are set.
Document NumbersDialog::changed(const std::vector<Row>& rows) const {
  const Registry& registry = *session_.app().registry;
  Document document = session_.document();
  std::vector<NamedNumber> table = tableOf(rows);
  for (const Row& row : rows)
    if (!row.before.isEmpty() && row.before != qt(row.now.name))
      document = withNumberRenamed(document, registry, row.before.toStdString(), row.now.name);
  return withNumbers(document, registry, table);
}

// There is always an empty row to write in.
void NumbersDialog::refresh() {
  const int last = table_->rowCount() - 1;
  const bool full =
      last < 0 || !table_->item(last, Name)->text().isEmpty() || !table_->item(last, Written)->text().isEmpty();
  if (full) addRow({}, {}, {});
  QString problem;
  NamedNumbers values;
  try {
    values = valuesOf(tableOf(rows()));
  } catch (const Error& error) {
    problem = qt(error.message());
  }
  for (int k = 0; k < table_->rowCount(); ++k) {
    const auto found = values.find(table_->item(k, Name)->text().trimmed().toStdString());
    table_->item(k, Result)->setText(found == values.end() ? QString() : shown(found->second));
  }
  problem_->setText(problem);
  ok_->setEnabled(problem.isEmpty());
}

void NumbersDialog::accept() {
  try {
    const Document document = changed(rows());
    if (document.extra() != session_.document().extra()) session_.commit(document, tr("Change named numbers"));
  } catch (const Error& error) {
    problem_->setText(qt(error.message()));
    return;
  }
  QDialog::accept();
}

}  // namespace blossom::ui
