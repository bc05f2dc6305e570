#include "document/edits.h"

#include <algorithm>

#include "core/file.h"
#include "document/file_access.h"
#include "feature/registry.h"
#include "support/documents.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Feature made(const FeatureId& id, Ids inputs = {}) {
  Feature feature;
  feature.id = feature.name = id;
  feature.type = "test.thing";
  feature.inputs = std::move(inputs);
  return feature;
}

/// a and b, c of both, d alone, e of c.
Document sample() {
  return Document().with(made("a")).with(made("b")).with(made("c", {"a", "b"})).with(made("d")).with(made("e", {"c"}));
}

Ids visible(const Document& document) {
  Ids ids;
  for (const auto& feature : document.features())
    if (feature->visible) ids.push_back(feature->id);
  return ids;
}

/// A type with a file among its parameters, under the command "reading".
Registry readers() {
  FeatureType type;
  type.id = "test.thing";
  type.command = "reading";
  type.title = type.summary = "Reading";
  ParameterSpec given = file("txt");
  given.name = "file";
  given.mayBeAbsent = true;
  type.parameters = {given};
  type.evaluate = [](const Value&, const Inputs&, const Progress&) { return Evaluated(); };
  Registry registry;
  registry.add(type);
  return registry;
}

/// Types that change a region, one that makes a mesh of it, and one that makes another region of it.
Registry editors() {
  Registry registry;
  for (const char* name : {"rounded", "grown", "meshed", "taken"}) {
    FeatureType type;
    type.id = std::string("test.") + name;
    type.command = type.title = type.summary = name;
    InputSpec shape;
    shape.name = shape.help = "shape";
    shape.kinds = {ShapeKind::Region};
    shape.use = type.command == "taken" ? InputUse::Consumed : InputUse::Edited;
    type.inputs = {shape};
    type.produces = {type.command == "meshed" ? ShapeKind::Mesh : ShapeKind::Region};
    type.evaluate = [](const Value&, const Inputs&, const Progress&) { return Evaluated(); };
    registry.add(type);
  }
  return registry;
}

Feature editing(const char* type, const FeatureId& id, const FeatureId& of) {
  Feature feature = made(id, {of});
  feature.type = std::string("test.") + type;
  return feature;
}

}  // namespace

class DocumentEditsTest : public QObject {
  Q_OBJECT

 private slots:
  void dependantsAreAllThatIsMadeOfThem() {
    QCOMPARE(dependants(sample(), {"a"}), (Ids{"c", "e"}));
    QCOMPARE(dependants(sample(), {"b", "c"}), (Ids{"e"}));
    QCOMPARE(dependants(sample(), {"d", "e"}), Ids{});
  }

  void visibilityAndSuppressionChangeNothingElse() {
    const Document before = sample();
    const Document hidden = withVisible(before, {"a", "d"}, false);
    QCOMPARE(visible(hidden), (Ids{"b", "c", "e"}));
    QVERIFY(hidden.features()[1] == before.features()[1]);  // shared
    QCOMPARE(visible(withVisible(hidden, {"d"}, true)), (Ids{"b", "c", "d", "e"}));
    const Document suppressed = withSuppressed(before, {"c"}, true);
    QVERIFY(suppressed.at("c").suppressed && !suppressed.at("e").suppressed);
    QVERIFY(withSuppressed(suppressed, {"c"}, false).at("c") == before.at("c"));
  }

  void oneAloneIsVisible() {
    const Document alone = withOnlyVisible(sample(), {"b", "e"});
    QCOMPARE(visible(alone), (Ids{"b", "e"}));
    QVERIFY(areOnlyVisible(alone, {"e", "b"}));
    QVERIFY(!areOnlyVisible(alone, {"b"}));
    QVERIFY(!areOnlyVisible(sample(), {"b"}));
    QVERIFY(!areOnlyVisible(Document(), {}));
  }

  void usersGoBeforeWhatTheyUse() {
    QCOMPARE(order(withoutAll(sample(), {"c", "a", "e"})), (Ids{"b", "d"}));
    VERIFY_ERROR(withoutAll(sample(), {"a"}), ErrorCode::InUse);
  }

  void theyMoveTogether() {
    QCOMPARE(order(withMoved(sample(), {"b", "d"}, 0)), (Ids{"b", "d", "a", "c", "e"}));
    QCOMPARE(order(withMoved(sample(), {"d", "e"}, 5)), (Ids{"a", "b", "c", "d", "e"}));
    QCOMPARE(order(withMoved(sample(), {"a", "d"}, 2)), (Ids{"b", "a", "d", "c", "e"}));
    VERIFY_ERROR(withMoved(sample(), {"c"}, 0), ErrorCode::InvalidInput);
    VERIFY_ERROR(withMoved(sample(), {"a"}, 4), ErrorCode::InvalidInput);
    QCOMPARE(order(*withStepped(sample(), {"d"}, -1)), (Ids{"a", "b", "d", "c", "e"}));
    QCOMPARE(order(*withStepped(sample(), {"d"}, 1)), (Ids{"a", "b", "c", "e", "d"}));
    QVERIFY(!withStepped(sample(), {"a"}, -1));
    QVERIFY(!withStepped(sample(), {"e"}, 1));
    QVERIFY(!withStepped(sample(), {}, 1));
  }

  /// a -> r -> g -> m, and another user of g.
  void editsOfAChainChangePlaces() {
    const Registry registry = editors();
    const Document chain = Document()
                               .with(made("a"))
                               .with(editing("rounded", "r", "a"))
                               .with(editing("grown", "g", "r"))
                               .with(editing("meshed", "m", "g"))
                               .with(editing("grown", "h", "g"));
    const auto up = withEditsExchanged(registry, chain, "g", -1), down = withEditsExchanged(registry, chain, "r", 1);
    QVERIFY(up && down);
    for (const Document& result : {*up, *down}) {
      QCOMPARE(order(result), (Ids{"a", "g", "r", "m", "h"}));
      QCOMPARE(result.at("g").inputs, Ids{"a"});
      QCOMPARE(result.at("r").inputs, Ids{"g"});
      QCOMPARE(result.at("m").inputs, Ids{"r"});
      QCOMPARE(result.at("h").inputs, Ids{"r"});
    }
    const auto back = withEditsExchanged(registry, *up, "r", -1);
    QVERIFY(back &&
            std::ranges::equal(back->features(), chain.features(), [](const auto& x, const auto& y) { return *x == *y; }));
    QVERIFY(!withEditsExchanged(registry, chain, "m", -1));  // a mesh cannot be grown
    QVERIFY(!withEditsExchanged(registry, chain, "g", 1));   // two are made of it
    QVERIFY(!withEditsExchanged(registry, chain, "h", -1));  // nor is it the only one
    QVERIFY(!withEditsExchanged(registry, chain, "r", -1));  // of no known type
    const Document taken = Document().with(made("a")).with(editing("taken", "t", "a")).with(editing("rounded", "r", "t"));
    QVERIFY(!withEditsExchanged(registry, taken, "r", -1));  // what it is taken from need not be what can be rounded
  }

  void namesAreCountedOn() {
    const Document document = Document().with(made("Box")).with(made("Box 2")).with(made("M8"));
    QCOMPARE(freeName(document, "Box"), std::string("Box 3"));
    QCOMPARE(freeName(document, "Box 2"), std::string("Box 3"));
    QCOMPARE(freeName(document, "M8"), std::string("M8 2"));
    QCOMPARE(freeName(document, "Ball"), std::string("Ball"));
  }

  void whatIsAddedHasANameOfItsOwn() {
    const Registry registry = readers();
    const auto type = registry.at("test.thing");
    Document document = Document().with(newFeature(Document(), *type));
    for (int k = 0; k < 3; ++k) document = document.with(newFeature(document, *type, {"reading-1"}));
    const auto names = [&] {
      std::vector<std::string> all;
      for (const auto& feature : document.features()) all.push_back(feature->name);
      return all;
    };
    QCOMPARE(names(), (std::vector<std::string>{"Reading", "Reading 2", "Reading 3", "Reading 4"}));
    QCOMPARE(order(document), (Ids{"reading-1", "reading-2", "reading-3", "reading-4"}));
    QCOMPARE(document.at("reading-3").inputs, Ids{"reading-1"});
    // A name that is free again is given again; the others keep theirs.
    document = document.without("reading-2");
    document = document.with(newFeature(document, *type));
    QCOMPARE(names(), (std::vector<std::string>{"Reading", "Reading 3", "Reading 4", "Reading 2"}));
    // From another document, too.
    FeatureId added;
    document = withFeatureOf(registry, document, Document().with(newFeature(Document(), *type)), "reading-1", &added);
    QCOMPARE(document.at(added).name, std::string("Reading 5"));
  }

  void anExcerptHoldsWhatIsNeeded() {
    const Document document = sample().withAsset("hash", std::make_shared<const std::string>("content"));
    QCOMPARE(order(excerpt(document, {"c"})), (Ids{"a", "b", "c"}));
    QCOMPARE(excerpt(document, {"d"}).assets().size(), std::size_t{1});
  }

  void copiesUseWhatIsThereAlready() {
    Ids added;
    const Document copied = withCopies(sample(), excerpt(sample(), {"c"}), {"c"}, added);
    QCOMPARE(added.size(), std::size_t{1});
    QCOMPARE(copied.features().size(), std::size_t{6});
    QCOMPARE(copied.at(added[0]).inputs, (Ids{"a", "b"}));
    QCOMPARE(copied.at(added[0]).name, std::string("c 2"));
    // Elsewhere, what they are made from comes along.
    added.clear();
    const Document fresh = withCopies(Document(), excerpt(sample(), {"c"}), {"c"}, added);
    QCOMPARE(order(fresh), (Ids{"a", "b", "c"}));
    QCOMPARE(added, Ids{"c"});
    // An input that is another one there does not serve.
    Feature other = made("a");
    other.parameters["size"] = 2;
    added.clear();
    const Document beside = withCopies(Document().with(other), excerpt(sample(), {"c"}), {"c"}, added);
    QCOMPARE(beside.features().size(), std::size_t{4});
    QVERIFY(beside.at("c").inputs[0] != "a");
  }

  void aFeatureMovesWithItsFiles() {
    const Registry registry = readers();
    Feature reading = made("b");
    reading.parameters["file"] = {{"path", "note.txt"}, {"asset", ""}};
    const TemporaryFolder folder;
    const Document other =
        Document().with(made("a")).with(reading).with(made("c", {"a", "b"})).withAccess(FileAccess::below(folder.path()));
    FeatureId added;
    const Document joined = withFeatureOf(registry, Document().with(made("a")), other, "c", &added);
    QCOMPARE(added, FeatureId("c"));
    QCOMPARE(joined.features().size(), std::size_t{4});
    QCOMPARE(joined.at("c").inputs, (Ids{"reading-1", "b"}));  // "a" is taken by another
    // Its relative path begins in the folder of the document that it came from.
    const std::filesystem::path named = joined.at("b").parameters.at("file").at("path").get<std::string>();
    QCOMPARE(named, std::filesystem::weakly_canonical(folder.path()) / "note.txt");
    VERIFY_ERROR(withFeatureOf(registry, Document(), other, "none", &added), ErrorCode::NotFound);
  }

  void aFileThatMayNotBeReadMayNotBeReadElsewhere() {
    const Registry registry = readers();
    Feature reading = made("b");
    reading.parameters["file"] = {{"path", "/somewhere/note.txt"}, {"asset", ""}};
    const TemporaryFolder folder;
    const Document other = Document().with(reading).withAccess(FileAccess::below(folder.path()));
    FeatureId added;
    const Document joined = withFeatureOf(registry, Document(), other, "b", &added);
    QVERIFY(joined.access());
    QVERIFY(!joined.access()->permits("/somewhere/note.txt"));
    QVERIFY(joined.access()->permits("/somewhere/else.txt"));
  }

  /// Each user goes on with the edit or stays as it is; the order of its inputs stays.
  void anEditGoesBeforeTheUsersThatAreNamed() {
    const Document before = sample().with(made("f", {"a"}));
    const Document after = withInserted(before, made("edit", {"a"}), {"c"});
    QCOMPARE(after.at("edit").inputs, Ids{"a"});
    QCOMPARE(after.at("c").inputs, (Ids{"edit", "b"}));
    QCOMPARE(after.at("f").inputs, Ids{"a"});
    QCOMPARE(after.at("e").inputs, Ids{"c"});
    QCOMPARE(after.features().size(), before.features().size() + 1);
    QCOMPARE(withInserted(before, made("edit", {"a"}), {"c", "f"}).at("f").inputs, Ids{"edit"});
    QCOMPARE(withInserted(before, made("edit", {"a"}), {}).at("c").inputs, (Ids{"a", "b"}));
  }

  void whatShowsTheStepsKeepsThem() {
    Registry registry = readers();
    FeatureType watching;
    watching.id = "test.watching";
    watching.command = "watching";
    watching.title = watching.summary = "Watching";
    watching.inputs = {{.name = "steps", .help = "", .kinds = {}, .maximum = anyNumber, .use = InputUse::Step}};
    watching.evaluate = [](const Value&, const Inputs&, const Progress&) { return Evaluated(); };
    registry.add(watching);
    Feature watcher = made("watcher", {"a"});
    watcher.type = watching.id;
    Feature unknown = made("unknown", {"a"});
    unknown.type = "elsewhere.thing";
    const Document document = sample().with(watcher).with(unknown);
    QCOMPARE(usersOfEdited(registry, document, "a"), (Ids{"c", "unknown"}));
    QCOMPARE(usersOfEdited(registry, document, "d"), Ids{});
  }

  void theLastFeatureIsNotSuppressed() {
    QCOMPARE(lastFeature(sample()).id, FeatureId("e"));
    QCOMPARE(lastFeature(withSuppressed(sample(), {"e"}, true)).id, FeatureId("d"));
    VERIFY_ERROR(lastFeature(Document()), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(DocumentEditsTest)
#include "document_edits_test.moc"
