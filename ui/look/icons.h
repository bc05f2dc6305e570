#pragma once
#include <QByteArray>
#include <QIcon>
#include <QPixmap>
#include <QString>

class QPainter;

namespace blossom::ui {

struct Theme;

/// A thin-line icon of resources/icons in the colours of the current theme, at any size and pixel ratio; faint when
/// disabled. An unknown name returns the plain ring "feature".
QIcon icon(const QString& name);
/// The same in the colour of text, for signs that must be found at once.
QIcon clearIcon(const QString& name);
/// Draws an icon into a rectangle in one colour (its accent stays the theme's).
void paintIcon(QPainter&, const QRectF&, const QString& name, const QColor&);
/// The SVG text with its colours replaced.
QByteArray iconSource(const QString& name, const QColor&, const Theme&);
bool hasIcon(const QString& name);

}  // namespace blossom::ui
