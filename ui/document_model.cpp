#include "ui/document_model.h"

#include <algorithm>

#include "ui/icons.h"
#include "ui/session.h"
#include "ui/text.h"

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
    case ShapeKind::None:
      break;
  }
  return QStringLiteral("feature");
}

}  // namespace

DocumentModel::DocumentModel(Session& session, QObject* parent) : QAbstractListModel(parent), session_(session) {
  connect(&session, &Session::documentChanged, this, &DocumentModel::refresh);
  connect(&session, &Session::viewChanged, this, [this](const QString& feature) {
    const QModelIndex index = indexOf(feature.toStdString());
    if (index.isValid()) emit dataChanged(index, index);
  });
  connect(&session, &Session::evaluationFinished, this, [this] {
    if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
  });
  refresh();
}

// Rows that stay keep their selection: only what differs is inserted or removed.
void DocumentModel::refresh() {
  const auto features = session_.document().features();
  const std::vector<std::shared_ptr<const Feature>> next(features.begin(), features.end());
  std::size_t same = 0;
  while (same < rows_.size() && same < next.size() && rows_[same]->id == next[same]->id) ++same;
  if (same < rows_.size()) {
    beginRemoveRows({}, static_cast<int>(same), static_cast<int>(rows_.size()) - 1);
    rows_.resize(same);
    endRemoveRows();
  }
  std::copy_n(next.begin(), same, rows_.begin());
  if (same < next.size()) {
    beginInsertRows({}, static_cast<int>(same), static_cast<int>(next.size()) - 1);
    rows_ = next;
    endInsertRows();
  }
  if (!rows_.empty()) emit dataChanged(index(0), index(rowCount() - 1));
}

int DocumentModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

FeatureId DocumentModel::idAt(const QModelIndex& index) const {
  return index.isValid() && index.row() < rowCount() ? rows_[static_cast<std::size_t>(index.row())]->id : FeatureId();
}

QModelIndex DocumentModel::indexOf(const FeatureId& id) const {
  const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const auto& feature) { return feature->id == id; });
  return it == rows_.end() ? QModelIndex() : index(static_cast<int>(it - rows_.begin()));
}

QString DocumentModel::stateOf(const Feature& feature) const {
  if (feature.suppressed) return tr("suppressed");
  const auto view = session_.view(feature.id);
  if (!view) return session_.evaluating() ? tr("computing…") : tr("not computed");
  if (view->result->error) return qt(view->result->error->message());
  return stateLine(view->measures);
}

QString DocumentModel::iconOf(const Feature& feature) const {
  const auto type = session_.app().registry->find(feature.type);
  if (type && hasIcon(qt(type->icon)) && type->id.rfind("exchange.", 0) != 0) return qt(type->icon);
  const auto view = session_.view(feature.id);
  return view ? iconOfKind(view->result->evaluated.shape.kind()) : QStringLiteral("pending");
}

QVariant DocumentModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Feature& feature = *rows_[static_cast<std::size_t>(index.row())];
  const auto view = session_.view(feature.id);
  switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
      return qt(feature.name);
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      return stateOf(feature);
    case IdRole:
      return qt(feature.id);
    case StateRole:
      return stateOf(feature);
    case FailedRole:
      return view && view->result->error.has_value();
    case WarnedRole:
      return view && !view->result->evaluated.warnings.empty();
    case PendingRole:
      return !view;
    case IconRole:
      return iconOf(feature);
    case VisibleRole:
      return feature.visible;
    default:
      return {};
  }
}

bool DocumentModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  const std::string name = value.toString().trimmed().toStdString();
  if (role != Qt::EditRole || !index.isValid() || name.empty()) return false;
  Feature feature = *rows_[static_cast<std::size_t>(index.row())];
  if (feature.name == name) return false;
  const QString what = tr("Rename %1").arg(qt(feature.name));
  feature.name = name;
  session_.commit(session_.document().with(feature), what);
  return true;
}

Qt::ItemFlags DocumentModel::flags(const QModelIndex&) const {
  return Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable;
}

}  // namespace blossom::ui
