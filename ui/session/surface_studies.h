#pragma once
#include <QObject>
#include <QString>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>

#include "core/error.h"
#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "scene/surface_study.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"

namespace blossom::ui {

/// Curvatures and iso-curves of shapes that are shown, made one after the other on a thread of their own when a display asks
/// for them. The last ones are kept. Of the window's thread.
class SurfaceStudies : public QObject {
  Q_OBJECT
 public:
  explicit SurfaceStudies(QObject* parent = nullptr) : QObject(parent) {}
  ~SurfaceStudies() override;

  /// The study of a shape as it is drawn with this chord (see DisplayCache); nullptr while there is none.
  [[nodiscard]] std::shared_ptr<const SurfaceStudy> known(const Shape&, double chord, int isoCurves);
  /// Makes it, unless it is there or under way, or was cancelled or failed before. `arrived` tells when it is there.
  void want(const Shape&, double chord, int isoCurves);
  /// The studies of a document with so many features are kept. It never becomes smaller.
  void makeRoomFor(std::size_t features);
  [[nodiscard]] bool running() const { return waiting_ > 0; }
  void cancel();      ///< what is under way or waits, and is not made again until `allowAgain`
  void allowAgain();  ///< what was cancelled or failed may be asked for once more

 signals:
  void started();
  void progressed(double fraction, const QString& stage);
  void arrived();
  void ended();  ///< nothing is under way any more
  void failed(const QString& message, const QString& hint);

 private:
  struct Key {
    const void* shape = nullptr;  ///< its address, which `Entry::shape` keeps
    double chord = 0;
    int isoCurves = 0;
    auto operator<=>(const Key&) const = default;
  };
  struct Entry {
    Key key;
    Shape shape;
    std::shared_ptr<const SurfaceStudy> study;  ///< nullptr: under way, or given up
    bool givenUp = false;
  };
  [[nodiscard]] Entry* find(const Key&);
  void take(const Key&, std::uint64_t round, std::shared_ptr<const SurfaceStudy>, const std::optional<Error>&);

  std::list<Entry> entries_;  // newest first
  std::size_t most_ = 48;
  int waiting_ = 0;
  std::uint64_t round_ = 0;  // grows with every cancelling: what comes from an older one is not counted
  CancelToken token_;
  Mailbox here_;
  Background thread_;  // ends first
};

}  // namespace blossom::ui
