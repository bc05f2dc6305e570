#include "ui/help/about_dialog.h"

#include <QClipboard>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/app.h"
#include "core/file.h"
#include "core/version.h"
#include "ui/help/about_versions.h"
#include "ui/look/icons.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

// Beside the resources in the source tree, among them when installed.
QString readLicence() {
  const std::filesystem::path folder = resourceFolder();
  for (const auto& file : {folder / "LICENSE", folder.parent_path() / "LICENSE"})
    if (std::filesystem::exists(file)) return qt(readFile(file));
  return AboutDialog::tr(
      "The text of the licence is not installed. It can be read at https://www.gnu.org/licenses/gpl-3.0.txt.");
}

}  // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent), body_(new QStackedWidget), licence_(new QPlainTextEdit) {
  setWindowTitle(tr("About Blossom"));
  setAttribute(Qt::WA_DeleteOnClose);
  licence_->setReadOnly(true);
  licence_->setObjectName(QStringLiteral("licenceText"));
  body_->addWidget(buildVersions());
  body_->addWidget(licence_);

  auto* copy = new QPushButton(tr("&Copy versions"));
  auto* licence = new QPushButton(tr("&Licence"));
  auto* close = new QPushButton(tr("Close"));
  licence->setCheckable(true);
  close->setDefault(true);
  close->setFocus();
  connect(copy, &QPushButton::clicked, this, &AboutDialog::copyVersions);
  connect(licence, &QPushButton::toggled, this, &AboutDialog::showLicence);
  connect(close, &QPushButton::clicked, this, &QDialog::accept);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(copy);
  buttons->addWidget(licence);
  buttons->addStretch(1);
  buttons->addWidget(close);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(28, 26, 28, 20);
  column->setSpacing(20);
  column->addWidget(buildHead());
  column->addWidget(body_, 1);
  column->addLayout(buttons);
}

QWidget* AboutDialog::buildHead() {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(20);
  auto* picture = new QLabel;
  picture->setPixmap(icon(QStringLiteral("blossom")).pixmap(QSize(72, 72), devicePixelRatioF()));
  auto* name = new QLabel(tr("Blossom %1").arg(QLatin1String(versionText)));
  name->setObjectName(QStringLiteral("startTitle"));
  auto* what =
      new QLabel(tr("A workbench for shapes that morph, sweep, grow and melt.\n"
                    "Free software under the GNU General Public License, version 3 or later."));
  what->setObjectName(QStringLiteral("featureSummary"));
  auto* column = new QVBoxLayout;
  column->setSpacing(6);
  column->addStretch(1);
  column->addWidget(name);
  column->addWidget(what);
  column->addStretch(1);
  row->addWidget(picture, 0, Qt::AlignTop);
  row->addLayout(column, 1);
  return head;
}

QWidget* AboutDialog::buildVersions() {
  const std::vector<LibraryVersion> versions = libraryVersions();
  versions_ = asText(versions);
  auto* table = new QWidget;
  auto* grid = new QGridLayout(table);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(20);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  int row = 0;
  for (const LibraryVersion& each : versions) {
    auto* name = new QLabel(each.name);
    name->setObjectName(QStringLiteral("resultName"));
    auto* version = new QLabel(each.version);
    version->setWordWrap(true);
    version->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(name, row, 0, Qt::AlignTop);
    grid->addWidget(version, row++, 1);
  }
  grid->setRowStretch(row, 1);
  return table;
}

void AboutDialog::copyVersions() const { QGuiApplication::clipboard()->setText(versions_); }

void AboutDialog::showLicence(bool shown) {
  if (shown && licence_->document()->isEmpty()) licence_->setPlainText(readLicence());
  body_->setCurrentIndex(shown ? 1 : 0);
  if (shown) resize(std::max(width(), 680), std::max(height(), 600));
}

QString AboutDialog::licenceText() const { return licence_->toPlainText(); }

}  // namespace blossom::ui
