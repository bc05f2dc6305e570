#include "ui/fields/list_field.h"

#include <QFrame>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <optional>

#include "core/error.h"
#include "feature/frame_keys.h"
#include "parameter/start_value.h"
#include "ui/fields/list_row.h"
#include "ui/look/icons.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

Value canonicalOrNothing(const ParameterSpec& spec, const Value& written) {
  try {
    return written.is_array() ? checked(spec, written) : Value::array();
  } catch (const Error&) {
    return Value::array();
  }
}

/// Where an item stands in a list: where it is expected, else the first that is equal.
std::optional<std::size_t> placeInList(const Value& list, const Value& item, std::size_t expected) {
  if (expected < list.size() && list[expected] == item) return expected;
  const auto found = std::find(list.begin(), list.end(), item);
  return found == list.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - list.begin()));
}

/// An item that is not declared to begin with anything begins as the one before it; those that belong to shapes do not.
bool goesOn(const ParameterSpec& list) {
  const ParameterSpec& item = list.fields.at(0);
  const auto given = [](const ParameterSpec& field) { return field.fallback.is_null() && !field.mayBeAbsent; };
  return list.filling.input.empty() && std::all_of(item.fields.begin(), item.fields.end(), given) &&
         !startValue(item).is_null();
}

constexpr std::size_t rowsAtOnce = 20;  // so that a list of thousands does not hold up the window

}  // namespace

ListField::ListField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent),
      limit_(rowsAtOnce),
      add_(new QToolButton),
      more_(new QPushButton),
      dropLine_(new QFrame(this)) {
  auto* body = new QWidget;
  column_ = new QVBoxLayout(body);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(5);
  more_->setObjectName(QStringLiteral("link"));
  more_->hide();
  column_->addWidget(more_);
  connect(more_, &QPushButton::clicked, this, [this] {
    limit_ += 2 * rowsAtOnce;
    fitRows();
  });
  add_->setObjectName(QStringLiteral("fieldButton"));
  add_->setProperty("role", QStringLiteral("add"));
  add_->setIcon(icon(QStringLiteral("plus")));
  add_->setToolTip(given.filling.input.empty() ? tr("Add an item") : tr("Add the missing items"));
  add_->setAccessibleName(tr("Add an item to %1").arg(registryText(label(given))));
  connect(add_, &QToolButton::clicked, this, &ListField::add);
  setWideEditor(body, add_);
  dropLine_->setObjectName(QStringLiteral("dropLine"));
  dropLine_->setFixedHeight(2);
  dropLine_->hide();
}

bool ListField::editing() const {
  return ParameterField::editing() || (value().is_array() ? draft_ != value() : !draft_.empty()) ||
         std::any_of(rows_.begin(), rows_.end(), [](const ListRow* row) { return row->editing(); });
}

void ListField::display(const Value& shown) {
  draft_ = shown.is_array() ? shown : Value::array();
  fitRows();
  given_ = Value();
}

Value ListField::written() const {
  Value all = value();
  if (!all.is_array()) return all;
  const Value canonical = canonicalOrNothing(spec(), held_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ParameterField* field = i < rows_.size() ? rows_[i]->field() : nullptr;
    if (field && field->value() == all[i])
      all[i] = field->written();
    else if (const auto place = placeInList(canonical, all[i], i))
      all[i] = held_[*place];
  }
  return all;
}

void ListField::fitRows() {
  const std::size_t count = std::min(draft_.size(), limit_);
  while (rows_.size() > count) {
    rows_.back()->hide();
    rows_.back()->deleteLater();  // it may be the one whose button was clicked
    rows_.pop_back();
  }
  while (rows_.size() < count) addRow();
  for (std::size_t i = 0; i < count; ++i) {
    if (given_.is_array() && i < given_.size()) rows_[i]->setWritten(given_[i]);
    rows_[i]->setValue(draft_[i]);
    rows_[i]->setEnds(i == 0, i + 1 == draft_.size());
  }
  add_->setEnabled(!full());
  more_->setVisible(draft_.size() > count);
  more_->setText(tr("%1 more").arg(draft_.size() - count));
}

void ListField::addRow() {
  const std::size_t index = rows_.size();
  auto* row = new ListRow(spec().fields.at(0), index, context(), nullptr);
  rows_.push_back(row);
  column_->insertWidget(static_cast<int>(index), row);
  connect(row, &ListRow::edited, this, [this, index](const Value& item) { replace(index, item, false); });
  connect(row, &ListRow::previewed, this, [this, index](const Value& item) { replace(index, item, true); });
  connect(row, &ListRow::reverted, this, &ListField::revert);
  connect(row, &ListRow::hint, this, &ListField::hint);
  connect(row, &ListRow::removeWanted, this, [this, index] { remove(index); });
  connect(row, &ListRow::copyWanted, this, [this, index] { copy(index); });
  connect(row, &ListRow::moveWanted, this, [this, index](int by) { move(index, index + static_cast<std::size_t>(by)); });
  connect(row, &ListRow::dragged, this, &ListField::showDropLine);
  connect(row, &ListRow::dropped, this, [this, index](int globalY) {
    dropLine_->hide();
    const std::size_t place = placeAt(globalY);
    move(index, place > index ? place - 1 : place);
  });
  connect(row, &ListRow::pickUnwanted, this, &ListField::pickUnwanted);
  connect(row, &ListRow::pickWanted, this, [this, index](ParameterField* from, PickRequest request) {
    const QString place = QString::number(index);
    request.parameter = request.parameter.isEmpty() ? place : place + u'/' + request.parameter;
    emit pickWanted(from, request);
  });
}

// In a dialog there are no inputs yet, and the list may become as long as it likes.
std::optional<std::size_t> ListField::wantedCount(const ParameterSpec& list) const {
  const auto shapes = context()->shapes.find(list.filling.input);
  if (shapes == context()->shapes.end()) return std::nullopt;
  return static_cast<std::size_t>(std::max(0, static_cast<int>(shapes->second) + list.filling.more));
}

bool ListField::full() const {
  const auto wanted = wantedCount(spec());
  return wanted && draft_.size() >= *wanted;
}

Value ListField::newItemOf(const ParameterSpec& list) const {
  const Value like = context()->parameters.value(list.filling.like, Value());
  return like.is_null() ? startValue(list.fields.at(0)) : like;
}

/// A list with items for shapes, as an item of this one, comes with all of them.
Value ListField::newItem() const {
  const ParameterSpec& item = spec().fields.at(0);
  const auto count = item.kind == ParameterKind::List ? wantedCount(item) : std::nullopt;
  if (!count) return goesOn(spec()) && !draft_.empty() ? draft_.back() : newItemOf(spec());
  Value filled = Value::array();
  while (filled.size() < *count) filled.push_back(newItemOf(item));
  return filled;
}

// What only the user can tell (a file) is asked for in the row; the list is passed on when it is given.
void ListField::add() {
  if (isFrameKeys(spec()) && context()->setKey()) return;
  const Value start = newItem();
  draft_.push_back(start);
  for (const std::size_t wanted = wantedCount(spec()).value_or(0); draft_.size() < wanted;) draft_.push_back(start);
  limit_ = std::max(limit_, draft_.size());
  fitRows();
  ListRow* row = rows_.back();
  row->open(true);
  if (!start.is_null()) offer(draft_);
  row->startTyping();
}

void ListField::replace(std::size_t index, const Value& item, bool preview) {
  Value all = draft_;
  all.at(index) = item;
  if (!preview) draft_ = all;
  offer(all, preview);
}

void ListField::move(std::size_t from, std::size_t to) {
  if (from == to || to >= draft_.size()) return;
  const Value item = draft_.at(from);
  draft_.erase(from);
  draft_.insert(draft_.begin() + static_cast<std::ptrdiff_t>(to), item);
  fitRows();
  offer(draft_);
}

// A list that needs its items keeps them.
void ListField::remove(std::size_t index) {
  Value rest = draft_;
  rest.erase(index);
  if (spec().minimum && static_cast<double>(rest.size()) < *spec().minimum) return offer(rest);  // says why
  draft_ = rest;
  fitRows();
  offer(draft_);
}

void ListField::copy(std::size_t index) {
  const Value item = draft_.at(index);
  draft_.insert(draft_.begin() + static_cast<std::ptrdiff_t>(index), item);
  limit_ = std::max(limit_, draft_.size());
  fitRows();
  offer(draft_);
}

std::size_t ListField::placeAt(int globalY) const {
  std::size_t place = 0;
  for (const ListRow* row : rows_)
    if (globalY > row->mapToGlobal(QPoint(0, row->height() / 2)).y()) ++place;
  return place;
}

void ListField::showDropLine(int globalY) {
  const std::size_t place = placeAt(globalY);
  const ListRow* row = place < rows_.size() ? rows_[place] : rows_.back();
  const int edge = place < rows_.size() ? -3 : row->height() + 1;
  dropLine_->setGeometry(0, mapFromGlobal(row->mapToGlobal(QPoint(0, edge))).y(), width(), 2);
  dropLine_->raise();
  dropLine_->show();
}

void ListField::addToMenu(QMenu& menu) {
  menu.addAction(add_->toolTip(), this, &ListField::add)->setEnabled(!full());
  menu.addAction(tr("Remove all"), this, [this] { offer(Value::array()); })->setEnabled(!draft_.empty());
}

}  // namespace blossom::ui
