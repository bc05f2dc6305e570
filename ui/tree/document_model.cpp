#include "ui/tree/document_model.h"

#include <QMimeData>
#include <algorithm>
#include <utility>

#include "ui/look/icons.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/session/session.h"
#include "ui/thread/refreshes.h"

namespace blossom::ui {

namespace {

QString iconOfKind(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::Region:
      return QStringLiteral("region");
    case ShapeKind::Curves:
      return QStringLiteral("curves");
    case ShapeKind::Curve:
      return QStringLiteral("curve");
    case ShapeKind::Surface:
      return QStringLiteral("surface");
    case ShapeKind::Brep:
      return QStringLiteral("solid");
    case ShapeKind::Mesh:
      return QStringLiteral("mesh");
    case ShapeKind::Motion:
      return QStringLiteral("motion");
    case ShapeKind::Sequence:
      return QStringLiteral("sequence");
    case ShapeKind::MedialAxis:
      return QStringLiteral("medial-axis");
    case ShapeKind::Toolpath:
      return QStringLiteral("toolpath");
    case ShapeKind::Setup:
      return QStringLiteral("setup");
    case ShapeKind::None:
      break;
  }
  return QStringLiteral("feature");
}

}  // namespace

DocumentModel::DocumentModel(Session& session, QObject* parent) : QAbstractListModel(parent), session_(session) {
  connect(&session, &Session::evaluationOverdue, this, &DocumentModel::refreshState);
  connect(&session, &Session::documentChanged, this, &DocumentModel::refresh);
  connect(&session, &Session::viewsChanged, this, &DocumentModel::refreshRows);
  connect(&session, &Session::evaluationFinished, this, &DocumentModel::refreshState);
  refresh();
}

std::vector<NestedRow> DocumentModel::wantedRows() const {
  return nestedRows(session_.document(), *session_.app().registry,
                    [this](const FeatureId& id) { return session_.shape(id); });
}

void DocumentModel::refreshState() {
  std::erase_if(shown_, [this](const auto& entry) { return !session_.document().contains(entry.first); });
  aboveTrouble_ = rowsAboveTrouble();
  std::vector<int> changed;
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (renew(row)) changed.push_back(static_cast<int>(row));
  tell(changed);
}

// A shape that has come may tell that an input stays beside its result, so that it is no step.
void DocumentModel::refreshRows(const std::set<FeatureId>& features) {
  if (wantedRows() != rows_) return refresh();
  const std::set<FeatureId> before = std::exchange(aboveTrouble_, rowsAboveTrouble());
  const auto concerned = [&](const FeatureId& id) {
    return features.contains(id) || before.contains(id) != aboveTrouble_.contains(id);
  };
  std::vector<int> changed;
  for (std::size_t row = 0; row < rows_.size(); ++row)
    if (concerned(rows_[row].feature->id) && renew(row)) changed.push_back(static_cast<int>(row));
  tell(changed);
}

/// False when the row shows what it showed before.
bool DocumentModel::renew(std::size_t row) {
  const Feature& feature = *rows_[row].feature;
  Shown now{rows_[row].feature,
            stateOf(feature),
            remedyOf(feature),
            iconOf(feature),
            pending(feature),
            failed(feature),
            warned(feature) || hidesTrouble(feature),
            rows_[row].steps,
            rows_[row].depth};
  Shown& before = shown_[feature.id];
  if (now == before) return false;
  before = std::move(now);
  return true;
}

/// Neighbours are told of together.
void DocumentModel::tell(const std::vector<int>& rows) {
  if (!rows.empty()) countRefresh(WindowPart::Tree);
  for (std::size_t from = 0, to = 0; from < rows.size(); from = to) {
    for (to = from + 1; to < rows.size() && rows[to] == rows[to - 1] + 1;) ++to;
    emit dataChanged(index(rows[from]), index(rows[to - 1]));
  }
}

// Rows that stay keep their selection: what is gone is removed, what stays is put in order, what is new is inserted.
void DocumentModel::refresh() {
  const std::vector<NestedRow> wanted = wantedRows();
  removeGone(wanted);
  reorder(wanted);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    if (i < rows_.size() && rows_[i].feature->id == wanted[i].feature->id) {
      rows_[i] = wanted[i];
      continue;
    }
    beginInsertRows({}, static_cast<int>(i), static_cast<int>(i));
    rows_.insert(rows_.begin() + static_cast<std::ptrdiff_t>(i), wanted[i]);
    endInsertRows();
  }
  renewFolds();
  refreshState();
}

void DocumentModel::removeGone(const std::vector<NestedRow>& wanted) {
  std::set<FeatureId> there;
  for (const NestedRow& row : wanted) there.insert(row.feature->id);
  for (std::size_t i = rows_.size(); i-- > 0;) {
    if (there.contains(rows_[i].feature->id)) continue;
    beginRemoveRows({}, static_cast<int>(i), static_cast<int>(i));
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(i));
    endRemoveRows();
  }
}

void DocumentModel::reorder(const std::vector<NestedRow>& wanted) {
  std::map<FeatureId, std::size_t> place;
  for (const NestedRow& row : wanted) place.emplace(row.feature->id, place.size());
  const auto byPlace = [&](const NestedRow& a, const NestedRow& b) {
    return place.at(a.feature->id) < place.at(b.feature->id);
  };
  if (std::is_sorted(rows_.begin(), rows_.end(), byPlace)) return;
  emit layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  std::vector<FeatureId> ids;
  ids.reserve(static_cast<std::size_t>(before.size()));
  for (const QModelIndex& each : before) ids.push_back(idAt(each));
  std::sort(rows_.begin(), rows_.end(), byPlace);
  QModelIndexList after;
  for (const FeatureId& id : ids) after << indexOf(id);
  changePersistentIndexList(before, after);
  emit layoutChanged();
}

int DocumentModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

const Feature& DocumentModel::at(const QModelIndex& index) const {
  return *rows_[static_cast<std::size_t>(index.row())].feature;
}

FeatureId DocumentModel::idAt(const QModelIndex& index) const {
  return index.isValid() && index.row() < rowCount() ? at(index).id : FeatureId();
}

QModelIndex DocumentModel::indexOf(const FeatureId& id) const {
  const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const NestedRow& row) { return row.feature->id == id; });
  return it == rows_.end() ? QModelIndex() : index(static_cast<int>(it - rows_.begin()));
}

FeatureId DocumentModel::parentOf(const FeatureId& id) const {
  const QModelIndex found = indexOf(id);
  return found.isValid() ? rows_[static_cast<std::size_t>(found.row())].parent : FeatureId();
}

std::vector<FeatureId> DocumentModel::stepsOf(const FeatureId& id) const {
  std::set<FeatureId> within{id};
  std::vector<FeatureId> steps;
  for (const NestedRow& row : rows_)  // a step comes after the row that it is a step of
    if (within.contains(row.parent) && within.insert(row.feature->id).second) steps.push_back(row.feature->id);
  return steps;
}

void DocumentModel::setFolded(const FeatureId& id, bool folded) {
  if (folded ? unfolded_.erase(id) == 0 : !unfolded_.insert(id).second) return;
  const QModelIndex row = indexOf(id);
  emit dataChanged(row, row);
  renewFolds();
}

// A step comes after the row that it is a step of.
void DocumentModel::renewFolds() {
  std::set<FeatureId> away;
  for (const NestedRow& row : rows_)
    if (!row.parent.empty() && (!unfolded_.contains(row.parent) || away.contains(row.parent))) away.insert(row.feature->id);
  if (away == foldedAway_) return;
  foldedAway_ = std::move(away);
  emit foldsChanged();
}

void DocumentModel::unfoldTo(const FeatureId& id) {
  for (FeatureId parent = parentOf(id); !parent.empty(); parent = parentOf(parent)) setFolded(parent, false);
}

bool DocumentModel::computing(const Feature& feature) const { return !feature.suppressed && session_.awaited(feature.id); }

/// In front, for the end of a long line is not seen.
QString DocumentModel::stateOf(const Feature& feature) const {
  const QString own = ownStateOf(feature);
  return hidesTrouble(feature) && !failed(feature) ? tr("a step warns · %1").arg(own) : own;
}

QString DocumentModel::ownStateOf(const Feature& feature) const {
  if (feature.suppressed) return tr("suppressed");
  if (computing(feature)) return tr("computing…");
  if (session_.cancelled(feature.id)) return tr("cancelled");
  const auto view = session_.view(feature.id);
  if (!view) return session_.evaluating() ? tr("computing…") : tr("not computed");
  if (view->result->error) return qt(view->result->error->message());
  // What follows a drag may have fewer frames than what is made.
  const bool standIn = session_.coarse() && view->result->evaluated.shape.kind() == ShapeKind::Sequence;
  return standIn ? shownShapeKind(view->measures.kind) : stateLine(view->measures);
}

QString DocumentModel::remedyOf(const Feature& feature) const {
  const auto view = session_.view(feature.id);
  if (session_.cancelled(feature.id) && !feature.suppressed) return tr("Compute it in its properties.");
  if (feature.suppressed || computing(feature) || !view || !view->result->error) return {};
  return qt(view->result->error->hint());
}

QString DocumentModel::tipOf(const Feature& feature) const {
  QStringList lines{qt(feature.name) + QStringLiteral(" – ") + typeOf(feature), stateOf(feature)};
  if (const QString remedy = remedyOf(feature); !remedy.isEmpty()) lines << remedy;
  const auto view = session_.view(feature.id);
  if (view && !view->result->error && !feature.suppressed)
    for (const std::string& warning : view->result->evaluated.warnings) lines << shownWarning(warning);
  if (hidesTrouble(feature)) lines << tr("Unfold it to see which.");
  return lines.join(u'\n');
}

QString DocumentModel::typeOf(const Feature& feature) const {
  const auto type = session_.app().registry->find(feature.type);
  return type ? registryText(type->title) : qt(feature.type);
}

QString DocumentModel::iconOf(const Feature& feature) const {
  const auto type = session_.app().registry->find(feature.type);
  if (type && hasIcon(qt(type->icon)) && type->id.rfind("exchange.", 0) != 0) return qt(type->icon);
  const auto view = session_.view(feature.id);
  return view ? iconOfKind(view->result->evaluated.shape.kind()) : QStringLiteral("pending");
}

bool DocumentModel::failed(const Feature& feature) const {
  const auto view = session_.view(feature.id);
  return !feature.suppressed && !computing(feature) && view && view->result->error.has_value();
}

bool DocumentModel::warned(const Feature& feature) const {
  const auto view = session_.view(feature.id);
  return view && !view->result->evaluated.warnings.empty();
}

bool DocumentModel::hidesTrouble(const Feature& feature) const {
  return aboveTrouble_.contains(feature.id) && !unfolded_.contains(feature.id);
}

// A step comes after the row that it is a step of: from the end, all below a row has been seen.
std::set<FeatureId> DocumentModel::rowsAboveTrouble() const {
  std::set<FeatureId> above;
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
    const Feature& feature = *row->feature;
    const bool warns = !feature.suppressed && warned(feature);
    if (!row->parent.empty() && (warns || failed(feature) || above.contains(feature.id))) above.insert(row->parent);
  }
  return above;
}

bool DocumentModel::pending(const Feature& feature) const { return !session_.view(feature.id) || computing(feature); }

QVariant DocumentModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Feature& feature = at(index);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return qt(feature.name);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return tipOf(feature);
    case IdRole:
      return qt(feature.id);
    case StateRole:
      return stateOf(feature);
    case RemedyRole:
      return remedyOf(feature);
    case TypeRole:
      return typeOf(feature);
    case FailedRole:
      return failed(feature);
    case WarnedRole:
      return warned(feature) || hidesTrouble(feature);
    case PendingRole:
      return pending(feature);
    case IconRole:
      return iconOf(feature);
    case VisibleRole:
      return feature.visible;
    case SuppressedRole:
      return feature.suppressed;
    case DepthRole:
      return rows_[static_cast<std::size_t>(index.row())].depth;
    case FoldedRole:
      return !unfolded_.contains(feature.id);
    case StepsRole:
      return rows_[static_cast<std::size_t>(index.row())].steps;
    default:
      return {};
  }
}

bool DocumentModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::string name = value.toString().trimmed().toStdString();
  if (role != Qt::EditRole || !index.isValid() || name.empty()) return false;
  Feature feature = at(index);
  if (feature.name == name) return false;
  const QString what = tr("Rename %1").arg(qt(feature.name));
  feature.name = name;
  session_.commit(session_.document().with(feature), what);
  return true;
}

Qt::ItemFlags DocumentModel::flags(const QModelIndex& index) const {
  if (!index.isValid()) return Qt::ItemIsDropEnabled;  // between the rows, never on one
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable | Qt::ItemIsDragEnabled;
}

QStringList DocumentModel::mimeTypes() const { return {QStringLiteral("application/x-blossom-rows")}; }

QMimeData* DocumentModel::mimeData(const QModelIndexList& indexes) const {
  QStringList ids;
  for (const QModelIndex& index : indexes) ids << qt(idAt(index));
  auto* data = new QMimeData;
  data->setData(mimeTypes().front(), ids.join(u'\n').toUtf8());
  return data;
}

}  // namespace blossom::ui
