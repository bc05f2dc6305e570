#include "ui/files/sample_pictures.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/version.h"

namespace blossom::ui {

namespace {

QString drawingProgram() { return QCoreApplication::applicationDirPath() + QStringLiteral("/blossom"); }

}  // namespace

SamplePictures::SamplePictures(QObject* parent) : QObject(parent) {
  connect(&drawing_, &QProcess::finished, this, [this] {
    if (waiting_.isEmpty()) return;
    const QString file = waiting_.takeFirst();
    const QPixmap picture(cached(file));
    if (!picture.isNull()) emit ready(file, picture);
    next();
  });
  connect(&drawing_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error == QProcess::FailedToStart) waiting_.clear();
  });
}

SamplePictures::~SamplePictures() {
  drawing_.disconnect(this);
  drawing_.kill();
  drawing_.waitForFinished(2000);
}

// One name for one content, look and program.
QString SamplePictures::cached(const QString& file) {
  const QFileInfo info(file);
  const QString key = QStringLiteral("%1|%2|%3|%4x%5|%6")
                          .arg(info.absoluteFilePath())
                          .arg(info.size())
                          .arg(info.lastModified().toMSecsSinceEpoch())
                          .arg(size.width())
                          .arg(size.height())
                          .arg(QLatin1String(versionText));
  const QByteArray name = QCryptographicHash::hash(key.toUtf8(), QCryptographicHash::Sha1).toHex();
  return QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) + QStringLiteral("/blossom/pictures/") +
         QLatin1String(name) + QStringLiteral(".png");
}

void SamplePictures::request(const QStringList& files) {
  for (const QString& file : files) {
    if (!QFileInfo::exists(file)) continue;
    if (waiting_.contains(file)) continue;
    const QPixmap picture(cached(file));
    if (picture.isNull())
      waiting_ << file;
    else
      emit ready(file, picture);
  }
  if (drawing_.state() == QProcess::NotRunning) next();
}

void SamplePictures::stop() {
  waiting_.clear();
  drawing_.kill();
}

void SamplePictures::next() {
  if (waiting_.isEmpty()) return;
  const QString to = cached(waiting_.first());
  if (!QDir().mkpath(QFileInfo(to).path())) return waiting_.clear();
  drawing_.setStandardOutputFile(QProcess::nullDevice());
  drawing_.setStandardErrorFile(QProcess::nullDevice());
  drawing_.start(drawingProgram(),
                 {QStringLiteral("render"), waiting_.first(), QStringLiteral("-o"), to, QStringLiteral("--transparent"),
                  QStringLiteral("--threads"), QStringLiteral("1"), QStringLiteral("--size"),
                  QStringLiteral("%1x%2").arg(size.width()).arg(size.height())},
                 QIODevice::ReadOnly);
}

}  // namespace blossom::ui
