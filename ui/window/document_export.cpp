#include "ui/window/document_export.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>
#include <set>

#include "document/shown.h"
#include "exchange/format/frames.h"
#include "geometry/occt/merged_shape.h"
#include "ui/files/export_dialog.h"
#include "ui/look/text.h"
#include "ui/page/page.h"
#include "ui/session/file_places.h"
#include "ui/tree/document_tree.h"
#include "ui/window/document_files.h"

namespace blossom::ui {

namespace {

/// Of the features that have a result.
ExportScope scopeOf(const Session& session, const std::vector<FeatureId>& ids) {
  ExportScope scope;
  std::vector<ShapeKind> kinds;
  std::set<ShapeKind> frameKinds;
  for (const FeatureId& id : ids) {
    const auto view = session.view(id);
    if (!view || view->result->evaluated.shape.empty()) continue;
    scope.features.push_back(id);
    const Shape& shape = view->result->evaluated.shape;
    kinds.push_back(shape.kind());
    if (const auto* sequence = shape.get<Sequence>())
      for (const Shape& frame : sequence->frames) frameKinds.insert(frame.kind());
  }
  scope.kind = kinds.empty() ? ShapeKind::None : mergedKind(kinds);
  if (kinds.size() == 1) scope.frameKinds.assign(frameKinds.begin(), frameKinds.end());
  return scope;
}

std::vector<FeatureId> shownOnes(const Session& session) {
  return shownFeatures(session.document(), *session.app().registry, [&](const FeatureId& id) { return session.shape(id); });
}

/// The files of the frames of a sequence that are there already; the file dialog has asked about the one that was chosen.
std::vector<std::filesystem::path> framesThere(const Session& session, const std::vector<FeatureId>& ids,
                                               const std::filesystem::path& file, const Format& format,
                                               const Value& options) {
  const Shape* shape = ids.size() == 1 ? session.shape(ids.front()) : nullptr;
  std::vector<std::filesystem::path> there;
  if (!shape || shape->kind() != ShapeKind::Sequence) return there;
  for (const FileOfShape& each : filesOf(format, *shape, file, completed(format.writeOptions, options)))
    if (std::error_code ignored; each.path != file && std::filesystem::exists(each.path, ignored))
      there.push_back(each.path);
  return there;
}

/// What is together in one file has one kind, and a sequence has none with others.
bool mixesSequence(const Session& session, const ExportScope& scope) {
  if (scope.features.size() < 2) return false;
  return std::any_of(scope.features.begin(), scope.features.end(), [&](const FeatureId& id) {
    const Shape* const shape = session.shape(id);
    return shape && shape->kind() == ShapeKind::Sequence;
  });
}

}  // namespace

bool DocumentExport::mayReplace(const std::vector<std::filesystem::path>& there) const {
  if (there.empty()) return true;
  QMessageBox question(window_);
  question.setIcon(QMessageBox::NoIcon);
  const QString first = qt(there.front().filename().string());
  question.setText(
      there.size() == 1
          ? tr("Replace %1?").arg(first)
          : tr("Replace %1 files, %2 to %3?").arg(there.size()).arg(first, qt(there.back().filename().string())));
  question.setInformativeText(tr("Each frame of the sequence is a file of its own, and these are there already."));
  QPushButton* const replace = question.addButton(tr("Replace"), QMessageBox::AcceptRole);
  question.setDefaultButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  return question.clickedButton() == replace;
}

DocumentExport::DocumentExport(App app, QWidget* window) : QObject(window), app_(std::move(app)), window_(window) {}

// What is selected, or the last result; then all that is visible.
std::vector<ExportScope> DocumentExport::scopesOf(DocumentPage& page) {
  const Session& session = page.session();
  const Document& document = session.document();
  std::vector<FeatureId> selected = page.tree().selected();
  if (selected.empty() && !document.features().empty()) selected = {document.features().back()->id};
  std::vector<ExportScope> scopes{scopeOf(session, selected)};
  ExportScope& first = scopes.front();
  if (first.features.size() == 1)
    first.title = qt(document.at(first.features.front()).name);
  else
    first.title = tr("The %1 selected results as one file").arg(first.features.size());
  if (first.features.empty()) scopes.clear();
  ExportScope visible = scopeOf(session, shownOnes(session));
  visible.title = tr("All %1 visible results as one file").arg(visible.features.size());
  if (visible.features.size() > 1 && (scopes.empty() || visible.features != scopes.front().features))
    scopes.push_back(std::move(visible));
  return scopes;
}

void DocumentExport::choose(DocumentPage& page) {
  std::vector<ExportScope> scopes = scopesOf(page);
  const auto writable = [&](const ExportScope& each) { return !formatsFor(*app_.formats, each).empty(); };
  if (scopes.empty())
    return page.showError(Error(ErrorCode::InvalidInput, "There is no result to export yet.",
                                "Select a feature that has been computed without an error."));
  const bool none = std::none_of(scopes.begin(), scopes.end(), writable);
  if (none && mixesSequence(page.session(), scopes.front()))
    return page.showError(Error(ErrorCode::OutputNotSupported, tr("A sequence is exported alone.").toStdString(),
                                tr("Select the sequence or the shapes, not both.").toStdString()));
  if (none) return page.showError(Error(ErrorCode::OutputNotSupported, "No format can hold this kind of result yet."));
  auto* dialog = new ExportDialog(*app_.formats, std::move(scopes), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, &page, [this, dialog, &page] {
    dialog->remember();
    // Copies, for the dialog may be gone when a file was chosen: it deletes itself in the event loop.
    const Format& format = dialog->format();
    const auto ids = dialog->scope().features;
    const Value options = dialog->options();
    const Document& document = page.document();
    const QString extension = qt(format.extensions.front());
    const QString name = ids.size() == 1 && document.contains(ids.front())
                             ? qt(document.at(ids.front()).name).toLower().replace(u' ', u'-').remove(u'/')
                             : page.session().suggestedName();
    QString file = QFileDialog::getSaveFileName(
        window_, tr("Export"), lastFolder() + u'/' + (name.isEmpty() ? tr("untitled") : name) + u'.' + extension,
        QStringLiteral("%1 (*.%2)").arg(qt(format.title).replace(u'(', u'[').replace(u')', u']'), extension));
    if (file.isEmpty()) return;
    const bool right = app_.formats->find(QFileInfo(file).suffix().toStdString()) == &format;
    if (!right && !completed(file, u'.' + extension, window_)) return;
    if (!mayReplace(framesThere(page.session(), ids, file.toStdString(), format, options))) return;
    rememberFolder(file);
    page.session().exportFeatures(ids, file.toStdString(), options);
  });
  dialog->open();
}

}  // namespace blossom::ui
