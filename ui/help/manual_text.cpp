#include "ui/help/manual_text.h"

#include <QImageReader>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextFrame>
#include <QTextTable>

#include "app/app.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr int widestColumn = 760, narrowestMargin = 28;
constexpr int textSize = 14, codeSize = 13;
constexpr int headingSizes[] = {26, 18, 15, 14, 14, 14};

const QString scheme = QStringLiteral("manual");

QUrl urlOf(const QString& page, const QString& anchor = {}) {
  QUrl url;
  url.setScheme(scheme);
  url.setPath(u'/' + page);
  if (!anchor.isEmpty()) url.setFragment(anchor);
  return url;
}

QString nameOf(const QUrl& url) { return url.path().mid(1); }

bool isCode(const QTextBlockFormat& format) {
  return format.hasProperty(QTextFormat::BlockCodeFence) || format.hasProperty(QTextFormat::BlockCodeLanguage);
}

QStringList codeFamilies() {
  return {QStringLiteral("JetBrains Mono"), QStringLiteral("DejaVu Sans Mono"), QStringLiteral("monospace")};
}

QTextCharFormat styled(QTextCharFormat format, int headingLevel, bool code) {
  const Theme& colors = theme();
  const bool link = !format.anchorHref().isEmpty();
  format.setForeground(colors.color(link ? "control" : "text"));
  if (link) format.setFontUnderline(false);
  if (code || format.fontFixedPitch()) {
    format.setFontFamilies(codeFamilies());
    format.setProperty(QTextFormat::FontPixelSize, codeSize);
    if (!code) format.setBackground(colors.color("field"));
  }
  if (headingLevel > 0) {
    format.clearProperty(QTextFormat::FontSizeAdjustment);  // it would win over the size
    format.setProperty(QTextFormat::FontPixelSize, headingSizes[headingLevel - 1]);
    format.setFontWeight(QFont::DemiBold);
  }
  return format;
}

bool holdsPicture(const QTextBlock& block) {
  for (auto it = block.begin(); !it.atEnd(); ++it)
    if (it.fragment().charFormat().isImageFormat()) return true;
  return false;
}

QTextBlockFormat spacing(const QTextBlock& block, const Theme& colors) {
  QTextBlockFormat format;
  const bool inTable = QTextCursor(block).currentTable() != nullptr;
  const int level = block.blockFormat().headingLevel();
  if (!holdsPicture(block)) format.setLineHeight(level > 0 ? 115 : 140, QTextBlockFormat::ProportionalHeight);
  format.setTopMargin(level == 1 ? 6 : level > 1 ? 24 : 0);
  format.setBottomMargin(inTable ? 0 : level > 0 ? 8 : block.textList() ? 3 : 10);
  if (isCode(block.blockFormat())) {
    const bool last = !isCode(block.next().blockFormat());
    format.setBackground(colors.color("field"));
    format.setLineHeight(0, QTextBlockFormat::SingleHeight);  // any other leaves stripes between the lines
    format.setTopMargin(0);
    format.setBottomMargin(last ? 14 : 0);
    format.setNonBreakableLines(false);
  }
  return format;
}

}  // namespace

ManualText::ManualText(QWidget* parent) : QTextBrowser(parent) {
  setObjectName(QStringLiteral("manualText"));
  setFrameShape(QFrame::NoFrame);
  setOpenExternalLinks(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QTextBrowser::sourceChanged, this, &ManualText::pageLoaded);
  connect(&ThemeManager::instance(), &ThemeManager::changed, this, [this] {
    if (pages_) reload();
  });
}

void ManualText::setPages(const ManualPages* pages) { pages_ = pages; }

void ManualText::open(const QString& page, const QString& anchor) { setSource(urlOf(page, anchor)); }

QVariant ManualText::loadResource(int type, const QUrl& url) {
  if (url.scheme() != scheme) return {};
  if (type != QTextDocument::ImageResource) {
    fresh_ = true;
    const ManualPage* page = pages_ ? pages_->find(nameOf(url)) : nullptr;
    return page ? page->text : tr("# No such page\n\nThe manual has no page \"%1\".").arg(nameOf(url));
  }
  QImageReader reader(qt((resourceFolder() / "manual" / nameOf(url).toStdString()).string()));
  const QSize size = reader.size();
  const qreal ratio = devicePixelRatioF();
  const int width = std::min(size.width(), static_cast<int>(columnWidth() * ratio));
  QImage image = reader.read();
  if (image.isNull()) return {};
  if (width < image.width())
    image = image.convertToFormat(QImage::Format_ARGB32_Premultiplied).scaledToWidth(width, Qt::SmoothTransformation);
  image.setDevicePixelRatio(ratio);
  return image;
}

// `source()` is still that of the page before when this is told.
void ManualText::pageLoaded(const QUrl& url) {
  shown_ = nameOf(url);
  if (std::exchange(fresh_, false)) style();
  if (url.hasFragment()) scrollToAnchor(url.fragment());
  emit pageChanged(shown_);
}

int ManualText::columnWidth() const { return std::clamp(viewport()->width() - 2 * narrowestMargin, 200, widestColumn); }

void ManualText::fitColumn() {
  QTextFrameFormat format = document()->rootFrame()->frameFormat();
  const int side = std::max(narrowestMargin, (viewport()->width() - widestColumn) / 2);
  format.setLeftMargin(side);
  format.setRightMargin(side);
  format.setTopMargin(22);
  format.setBottomMargin(40);
  document()->rootFrame()->setFrameFormat(format);
}

// Pictures are made anew for another width when the page is opened the next time; while dragging they may overhang.
void ManualText::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  fitColumn();
}

// QTextDocument reads Markdown with a look of its own and takes style sheets for HTML only: the formats are set here.
void ManualText::style() {
  headings_.clear();
  document()->setDocumentMargin(0);
  QFont base = font();
  base.setPixelSize(textSize);
  document()->setDefaultFont(base);
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) styleBlock(cursor, block);
  for (QTextFrame* frame : document()->rootFrame()->childFrames())
    if (auto* table = qobject_cast<QTextTable*>(frame)) styleTable(*table);
  cursor.endEditBlock();
  fitColumn();
}

void ManualText::styleBlock(QTextCursor& cursor, const QTextBlock& block) {
  const Theme& colors = theme();
  const int level = block.blockFormat().headingLevel();
  const bool code = isCode(block.blockFormat());
  cursor.setPosition(block.position());
  cursor.mergeBlockFormat(spacing(block, colors));
  if (level > 0) headings_.push_back({block.text(), anchorOf(block.text()), level});
  for (auto it = block.begin(); !it.atEnd(); ++it) {
    const QTextFragment fragment = it.fragment();
    if (fragment.charFormat().isImageFormat()) continue;
    cursor.setPosition(fragment.position());
    cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
    cursor.setCharFormat(styled(fragment.charFormat(), level, code));
    if (level > 0) {
      QTextCharFormat anchor;
      anchor.setAnchor(true);
      anchor.setAnchorNames({anchorOf(block.text())});
      cursor.mergeCharFormat(anchor);
    }
  }
}

void ManualText::styleTable(QTextTable& table) {
  const Theme& colors = theme();
  QTextTableFormat format = table.format();
  format.setBorder(1);
  format.setBorderCollapse(true);
  format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
  format.setBorderBrush(colors.color("border"));
  format.setCellPadding(6);
  format.setCellSpacing(0);
  format.setTopMargin(4);
  format.setBottomMargin(14);
  format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
  table.setFormat(format);
  for (int column = 0; column < table.columns(); ++column) {
    QTextTableCell cell = table.cellAt(0, column);
    QTextCursor title = cell.firstCursorPosition();
    if (title.block().text().isEmpty() && title.block() != cell.lastCursorPosition().block()) title.deleteChar();
    title.setPosition(cell.lastPosition(), QTextCursor::KeepAnchor);
    QTextCharFormat bold;
    bold.setFontWeight(QFont::DemiBold);
    title.mergeCharFormat(bold);
    QTextCharFormat head;
    head.setBackground(colors.color("hover"));
    cell.setFormat(head);
  }
}

void ManualText::highlight(const QString& words) {
  QList<QTextEdit::ExtraSelection> marks;
  for (const QString& word : words.split(u' ', Qt::SkipEmptyParts))
    for (QTextCursor found = document()->find(word); !found.isNull(); found = document()->find(word, found)) {
      QTextEdit::ExtraSelection mark;
      mark.cursor = found;
      mark.format.setBackground(theme().color("madeSoft"));
      marks.append(mark);
    }
  setExtraSelections(marks);
}

}  // namespace blossom::ui
