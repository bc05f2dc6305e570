#include "geometry/numeric/box_tree.h"

#include <set>

#include "core/vector.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

template <int N>
std::vector<Eigen::AlignedBox<double, N>> randomBoxes(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<double> place(-10, 10), size(0, 1);
  std::vector<Eigen::AlignedBox<double, N>> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Matrix<double, N, 1> low, reach;
    for (int k = 0; k < N; ++k) low[k] = place(random), reach[k] = i % 5 == 0 ? 0 : size(random);
    boxes.emplace_back(low, low + reach);
    if (i % 7 == 0) boxes.push_back(boxes.back());  // at the same place
  }
  return boxes;
}

template <int N>
void compareWithSearchThroughAll(std::mt19937_64& random, std::size_t count) {
  const auto boxes = randomBoxes<N>(random, count);
  const BoxTree<N> tree(boxes);
  for (const auto& wanted : randomBoxes<N>(random, 40)) {
    double nearest = std::numeric_limits<double>::infinity(), found = nearest;
    std::set<std::size_t> meeting, behind;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      nearest = std::min(nearest, boxDistance(boxes[i], wanted));
      if (boxes[i].intersects(wanted)) meeting.insert(i);
    }
    tree.walk([&](const auto& box) { return boxDistance(box, wanted); },
              [&](std::size_t i) { found = std::min(found, boxDistance(boxes[i], wanted)); },
              [&](double distance) { return distance < found; });
    QCOMPARE(found, nearest);
    std::multiset<std::size_t> met, metBehind;
    const std::size_t from = boxes.size() / 2;
    tree.meeting(wanted, [&](std::size_t i) {
      if (boxes[i].intersects(wanted)) met.insert(i);
    });
    tree.meeting(
        wanted, [&](std::size_t i) { metBehind.insert(i); }, from);
    QVERIFY(std::equal(met.begin(), met.end(), meeting.begin(), meeting.end()));
    for (const std::size_t i : metBehind) QVERIFY(i >= from);
    for (const std::size_t i : meeting)
      if (i >= from) QCOMPARE(metBehind.count(i), std::size_t{1});
  }
}

template <int N>
void comparePairs(std::mt19937_64& random, std::size_t count) {
  const auto boxes = randomBoxes<N>(random, count);
  constexpr double margin = 0.25;
  std::set<std::pair<std::size_t, std::size_t>> wanted;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (comeNear(boxes[i], boxes[j], margin)) wanted.emplace(i, j);
  std::multiset<std::pair<std::size_t, std::size_t>> found;
  forEachNearPair<N>(boxes, margin, Progress::none(), [&](std::size_t i, std::size_t j) {
    found.insert(std::minmax(i, j));
    return true;
  });
  QVERIFY(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end()));
  std::size_t calls = 0;
  forEachNearPair<N>(boxes, margin, Progress::none(), [&](std::size_t, std::size_t) { return ++calls < 3; });
  QCOMPARE(calls, std::min<std::size_t>(3, wanted.size()));
}

}  // namespace

class BoxTreeTest : public QObject {
  Q_OBJECT

 private slots:
  void findsWhatASearchThroughAllFinds() {
    auto random = seededRandom();
    for (const std::size_t count : {1, 4, 5, 700}) {
      compareWithSearchThroughAll<2>(random, count);
      compareWithSearchThroughAll<3>(random, count);
      comparePairs<2>(random, count);
      comparePairs<3>(random, count);
    }
  }

  void boxesAtOnePlaceEndTheHalving() {
    const std::vector<Box3> boxes(10'000, Box3(Vec3(1, 2, 3)));
    const BoxTree<3> tree(boxes);
    std::size_t met = 0;
    tree.meeting(boxes[0], [&](std::size_t) { ++met; });
    QCOMPARE(met, boxes.size());
  }

  void anEmptyTreeHoldsNothing() {
    const BoxTree<2> tree(std::span<const Box2>{});
    QVERIFY(tree.empty());
    tree.meeting(Box2(Vec2(0, 0)), [](std::size_t) { QFAIL("an item of nothing"); });
  }

  void buildingCanBeCancelled() {
    const std::vector<Box2> boxes(5000, Box2(Vec2(0, 0)));
    const CancelToken token;
    token.cancel();
    VERIFY_ERROR(BoxTree<2>(boxes, 4, Progress(token)), ErrorCode::Cancelled);
  }
};

BLOSSOM_TEST(BoxTreeTest)
#include "box_tree_test.moc"
