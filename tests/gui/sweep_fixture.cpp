#include "sweep_fixture.h"

#include <QDir>
#include <cmath>

#include "ui/tree/document_tree.h"

namespace blossom::ui {

using test::sample;

void SweepFixture::openSample(const char* name) {
  openAndWait(QString::fromStdString(sample(name).string()));
  sweep_ = sweep();
  source_ = document().at(sweep_).inputs.front();
  window_->view().lookFrom(QStringLiteral("iso"), false);
  window_->view().fit(false);
  window_->tree().select(sweep_);
  window_->view().setFocus();
}

void SweepFixture::hover(const QPoint& at) {
  const auto over = [&] {
    mouse(QEvent::MouseMove, at);
    return !hint().isEmpty() && !hint().startsWith(QStringLiteral("Drag a place"));
  };
  QTRY_VERIFY2_WITH_TIMEOUT(over(), qPrintable("the surface cannot be taken hold of: " + hint()), 60000);
}

void SweepFixture::hover(const QPoint& at, const QString& wanted) {
  const auto over = [&] {
    mouse(QEvent::MouseMove, at);
    return hint().startsWith(wanted);
  };
  QTRY_VERIFY2_WITH_TIMEOUT(over(), qPrintable("what is there cannot be taken hold of: " + hint()), 60000);
}

void SweepFixture::drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
  hover(from);
  mouse(QEvent::MouseButtonPress, from);
  for (int k = 1; k <= 6; ++k) mouse(QEvent::MouseMove, from + (to - from) * k / 6, modifiers);
  mouse(QEvent::MouseButtonRelease, to, modifiers);
  waitUntilComputed();
}

QPoint SweepFixture::onTheSide() const {
  const Vec3 eye = window_->view().camera().turn().toCamera();
  const double azimuth = std::atan2(eye.y(), eye.x()) + 0.8;
  return screenOf(Vec3(10 * std::cos(azimuth), 10 * std::sin(azimuth), 21));
}

QPoint SweepFixture::onABlade() {
  window_->view().lookFrom(QStringLiteral("top"), false);
  window_->view().fit(false);
  Vec3 tip = Vec3::Zero();
  for (const Vec4& pole : surfaceOf(sweep_).poles)
    if (const Vec3 p = pole.head<3>() / pole[3]; p.head<2>().norm() > tip.head<2>().norm()) tip = p;
  return screenOf(Vec3(tip.x() / 2, tip.y() / 2, tip.z()));
}

std::vector<FeatureId> SweepFixture::all(const char* type) const {
  std::vector<FeatureId> found;
  for (const auto& feature : document().features())
    if (feature->type == type) found.push_back(feature->id);
  return found;
}

void SweepFixture::keepPictures(const char* name, std::optional<QPoint> at) {
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    if (at) mouse(QEvent::MouseMove, *at);
    QVERIFY(!canvas().isNull());
    const QPixmap picture = window_->grab();
    QVERIFY(!picture.isNull());
    const QString theme = choice == ThemeChoice::Light ? QStringLiteral("light") : QStringLiteral("dark");
    if (!folder.isEmpty())
      QVERIFY(picture.save(QDir(folder).filePath(QStringLiteral("%1-%2.png").arg(QLatin1String(name), theme))));
  }
}

}  // namespace blossom::ui
