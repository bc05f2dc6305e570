#include "ui/fields/file_field.h"

#include <QDragEnterEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMimeData>
#include <QToolButton>

#include "ui/controls/window_keys.h"
#include "ui/look/icons.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/session/file_places.h"

namespace blossom::ui {

FileField::FileField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), line_(new QLineEdit) {
  leaveKeysToTheWindow(line_);
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* browse = new QToolButton;
  browse->setObjectName(QStringLiteral("fieldButton"));
  browse->setIcon(icon(QStringLiteral("open")));
  browse->setToolTip(tr("Choose a file"));
  browse->setAccessibleName(tr("Choose a file"));
  line_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  line_->setPlaceholderText(given.mayBeAbsent ? tr("none") : tr("choose a file"));
  line_->setAcceptDrops(false);  // the field takes them
  row->addWidget(line_, 1);
  row->addWidget(browse);
  setEditor(both);
  both->setFocusProxy(line_);
  forgiveWhatIsTakenBack(line_);
  setAcceptDrops(true);
  connect(browse, &QToolButton::clicked, this, &FileField::choose);
  connect(line_, &QLineEdit::editingFinished, this, [this] {
    if (line_->isModified()) take(line_->text().trimmed());
  });
}

bool FileField::editing() const { return line_->isModified(); }

void FileField::display(const Value& shown) {
  line_->setText(displayText(spec(), shown));
  const QString path = shown.is_object() ? qt(shown.value("path", std::string())) : QString();
  line_->setToolTip(path.isEmpty() ? registryText(spec().help) : path);
  line_->setCursorPosition(0);
}

QStringList FileField::extensions() const { return qt(spec().fileTypes).split(u' ', Qt::SkipEmptyParts); }

void FileField::take(const QString& path) {
  const QStringList wanted = extensions();
  if (path.isEmpty()) return spec().mayBeAbsent ? offer(Value()) : revert();
  if (!wanted.isEmpty() && !wanted.contains(QFileInfo(path).suffix(), Qt::CaseInsensitive))
    return showProblem(tr("\"%1\" is not a file of the type %2. The value before is kept.")
                           .arg(QFileInfo(path).fileName(), wanted.join(tr(" or "))));
  if (!QFileInfo(path).isFile())
    return showProblem(tr("There is no file \"%1\". The value before is kept.").arg(QFileInfo(path).fileName()));
  offer(QFileInfo(path).absoluteFilePath().toStdString());
}

void FileField::choose() {
  const QString before = value().is_object() ? qt(value().value("path", std::string())) : QString();
  const QString from = QFileInfo(before).isAbsolute() ? QFileInfo(before).path() : lastFolder();
  auto* dialog = new QFileDialog(this, tr("Choose a file"), from);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  QStringList patterns;
  for (const QString& extension : extensions()) patterns << QStringLiteral("*.") + extension;
  if (!patterns.isEmpty()) dialog->setNameFilters({QStringLiteral("%1 (%2)").arg(shownLabel(spec()), patterns.join(u' '))});
  connect(dialog, &QFileDialog::fileSelected, this, &FileField::take);
  dialog->open();
}

void FileField::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) event->acceptProposedAction();
}

void FileField::dropEvent(QDropEvent* event) {
  event->acceptProposedAction();
  take(event->mimeData()->urls().front().toLocalFile());
}

}  // namespace blossom::ui
