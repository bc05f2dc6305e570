#pragma once
#include <QByteArray>
#include <QIcon>
#include <QPixmap>
#include <QString>

class QPainter;

namespace blossom::ui {

struct Theme;

/// A thin-line icon of resources/icons, drawn in the colours of the theme in use at any size and pixel ratio; disabled is
/// faint. An unknown name gives the plain ring "feature".
QIcon icon(const QString& name);
/// Draws an icon into a rectangle in one colour (its accent stays the theme's).
void paintIcon(QPainter&, const QRectF&, const QString& name, const QColor&);
/// The SVG text with its colours put in.
QByteArray iconSource(const QString& name, const QColor&, const Theme&);
bool hasIcon(const QString& name);

}  // namespace blossom::ui
