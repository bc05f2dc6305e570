#include "app/app.h"

#include <fmt/format.h>

#include <QTemporaryDir>

#include "core/file.h"
#include "document/edits.h"
#include "support/support.h"

using namespace blossom;

class AppTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void builtInTypesAndFormatsAreThere();
  void anImportedFileLivesInTheDocument();
  void aLinkedFileIsEmbeddedOnRequest();
  void filesThatCannotBeImported();
  void aFeatureMovesIntoAnotherDocument();
  void theLastFeatureIsTheLastThatWorks();
  void openAnyTakesDocumentsAndFiles();
  void aMotionFileBecomesASweep();
  void editsOfAMotionFileBecomeFeatures();
  void aDamagedMotionFileOpensWithAnImportThatTellsWhy();
  void whatOpensAKindOfShapeFollowsTheImport();
  void resourcesAreFound();
  void samplesNameNoFolderOfAMachine();
  void whatIsTakenInKeepsItsNameAlone();

 private:
  [[nodiscard]] std::filesystem::path file(const char* name) const {
    return std::filesystem::path(folder_->path().toStdString()) / name;
  }
  std::unique_ptr<QTemporaryDir> folder_;
  const App app_ = loadApp();
};

void AppTest::init() {
  folder_ = std::make_unique<QTemporaryDir>();
  writeAtomically(file("triangle.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
}

void AppTest::builtInTypesAndFormatsAreThere() {
  for (const char* id : {"exchange.import", "import", "blossom.literal", "literal"}) QVERIFY2(app_.registry->find(id), id);
  for (const char* extension :
       {"step", "iges", "brep", "stl", "obj", "off", "ply", "3mf", "dxf", "svg", "json", "png", "ogv"})
    QVERIFY2(app_.formats->find(extension), extension);
}

void AppTest::anImportedFileLivesInTheDocument() {
  FeatureId id;
  const Document document = withImported(app_, Document(), file("triangle.off"), &id);
  QCOMPARE(document.assets().size(), std::size_t{1});
  QCOMPARE(document.at(id).name, std::string("triangle"));
  QCOMPARE(document.at(id).parameters.at("file").at("asset").get<std::string>(),
           contentHash(readFile(file("triangle.off"))));
  std::filesystem::remove(file("triangle.off"));
  const Results results = Evaluator(app_.registry).evaluate(document, Progress::none());
  QVERIFY(!results.at(id)->error);
  QCOMPARE(results.at(id)->evaluated.shape.kind(), ShapeKind::Mesh);
}

void AppTest::aLinkedFileIsEmbeddedOnRequest() {
  FeatureId id;
  const Document linked = withLinked(app_, Document(), file("triangle.off"), &id);
  QVERIFY(linked.assets().empty());
  const Document embedded = withFilesEmbedded(*app_.registry, linked);
  QCOMPARE(embedded.assets().size(), std::size_t{1});
  QVERIFY(withFilesEmbedded(*app_.registry, embedded).at(id) == embedded.at(id));
}

void AppTest::filesThatCannotBeImported() {
  writeAtomically(file("text.unknown"), "text");
  writeAtomically(file("bare"), "text");
  VERIFY_ERROR(withImported(app_, Document(), file("none.off")), ErrorCode::FileNotFound);
  VERIFY_ERROR(withImported(app_, Document(), folder_->path().toStdString()), ErrorCode::FileUnreadable);
  VERIFY_ERROR(withImported(app_, Document(), file("text.unknown")), ErrorCode::FormatUnknown);
  VERIFY_ERROR(withImported(app_, Document(), file("bare")), ErrorCode::FormatUnknown);
}

void AppTest::aFeatureMovesIntoAnotherDocument() {
  FeatureId first, second, added;
  const Document one = withImported(app_, Document(), file("triangle.off"), &first);
  writeAtomically(file("other.off"), "OFF\n3 1 0\n0 0 0\n2 0 0\n0 2 0\n3 0 1 2\n");
  const Document two = withImported(app_, Document(), file("other.off"), &second);
  QCOMPARE(first, second);
  const Document both = withFeatureOf(*app_.registry, one, two, second, &added);
  QCOMPARE(both.features().size(), std::size_t{2});
  QVERIFY(added != first);
  QCOMPARE(both.assets().size(), std::size_t{2});
  QCOMPARE(both.at(added).name, std::string("other"));
  VERIFY_ERROR(withFeatureOf(*app_.registry, one, two, "none", &added), ErrorCode::NotFound);
}

void AppTest::theLastFeatureIsTheLastThatWorks() {
  VERIFY_ERROR(lastFeature(Document()), ErrorCode::InvalidInput);
  FeatureId first, second;
  Document document = withLinked(app_, Document(), file("triangle.off"), &first);
  document = withLinked(app_, document, file("triangle.off"), &second);
  QCOMPARE(lastFeature(document).id, second);
  QCOMPARE(document.at(first).name, std::string("triangle"));
  QCOMPARE(document.at(second).name, std::string("triangle 2"));
  Feature suppressed = document.at(second);
  suppressed.suppressed = true;
  QCOMPARE(lastFeature(document.with(suppressed)).id, first);
}

void AppTest::openAnyTakesDocumentsAndFiles() {
  const OpenedDocument imported = openAny(app_, file("triangle.off"));
  QCOMPARE(imported.document.features().size(), std::size_t{1});
  saveDocument(imported.document, file("model.BLOSSOM"));
  QVERIFY(isDocument(file("model.BLOSSOM")));
  QVERIFY(openAny(app_, file("model.BLOSSOM")).document.at(lastFeature(imported.document).id) ==
          lastFeature(imported.document));
  VERIFY_ERROR(openAny(app_, file("none.blossom")), ErrorCode::FileNotFound);
}

void AppTest::aMotionFileBecomesASweep() {
  const auto sample = test::sample("propeller.json");
  QVERIFY(std::filesystem::exists(sample));
  const OpenedDocument opened = openAny(app_, sample);
  QCOMPARE(lastFeature(opened.document).type, std::string("sweep.sweep"));
  const Results results = Evaluator(app_.registry).evaluate(opened.document, Progress::none());
  for (const auto& [id, result] : results) QVERIFY2(!result->error, result->error ? result->error->what() : "");
}

void AppTest::editsOfAMotionFileBecomeFeatures() {
  Value motion = Value::parse(readFile(test::sample("cylinder.json")));
  motion["edits"] = Value::parse(
      "[{\"at\": [0.125, 0.5], \"to\": [14, 14, 20], \"symmetry\": {\"fold\": 4}},"
      " {\"at\": [0.125, 0.5], \"twist\": {\"axis\": [1, 1, 0], \"angle\": 40}}]");
  const std::filesystem::path edited = file("edited.json");
  writeAtomically(edited, motion.dump());
  const Document document = openAny(app_, edited).document;
  const auto& features = document.features();
  std::vector<std::string> types;
  for (const auto& feature : features) types.push_back(feature->type);
  QCOMPARE(types, (std::vector<std::string>{"exchange.import", "sweep.pull", "sweep.twist", "sweep.sweep"}));
  for (std::size_t i = 1; i < features.size(); ++i)
    QCOMPARE(features[i]->inputs, std::vector<FeatureId>{features[i - 1]->id});

  Document linked;  // reads the same file with its edits, as the command line does
  FeatureId import;
  linked = withLinked(app_, linked, edited, &import);
  linked = linked.with(newFeature(linked, *app_.registry->at("sweep.sweep"), {import}));
  const auto surfaceOf = [&](const Document& made) {
    const Results results = Evaluator(app_.registry).evaluate(made, Progress::none());
    for (const auto& [id, result] : results)
      if (result->error) throw *result->error;
    return *results.at(lastFeature(made).id)->evaluated.shape.get<Surface>();
  };
  const Surface whole = surfaceOf(document);
  QVERIFY(whole == surfaceOf(linked));
  Feature twist = *features[2];
  twist.suppressed = true;
  QVERIFY(!(surfaceOf(document.with(twist)) == whole));
}

void AppTest::aDamagedMotionFileOpensWithAnImportThatTellsWhy() {
  writeAtomically(file("damaged.json"), "{\"trajectory\": 5}");
  const Document document = openAny(app_, file("damaged.json")).document;
  QCOMPARE(document.features().size(), std::size_t{2});
  const Results results = Evaluator(app_.registry).evaluate(document, Progress::none());
  QCOMPARE(results.at(document.features().front()->id)->error->code(), ErrorCode::FormatDamaged);
}

// Nothing in `app` knows the sweep: any feature type that declares it opens what a format reads.
void AppTest::whatOpensAKindOfShapeFollowsTheImport() {
  struct None {};
  const auto registry = std::make_shared<Registry>();
  Format dots;
  dots.id = "dots";
  dots.title = "Dots";
  dots.extensions = {"dots"};
  dots.reads = ShapeKind::Mesh;
  dots.read = [](const auto&, const auto&, const auto&) { return Imported{Mesh(), {}, {}, {}}; };
  registry->add(dots);
  registry->add(*app_.registry->at("import"));
  registry->add(feature<None>("made-up.count", "Count", "Counts dots.")
                    .input({"dots", "The dots.", {ShapeKind::Mesh}})
                    .opens(ShapeKind::Mesh)
                    .evaluate([](const None&, const Inputs& inputs, const Progress&) -> Evaluated {
                      return {inputs.of(0)[0], {}, {}};
                    }));
  App app;
  app.registry = registry;
  app.formats = std::shared_ptr<const FormatRegistry>(registry, &registry->formats());
  writeAtomically(file("three.dots"), "...");
  const Document document = openAny(app, file("three.dots")).document;
  QCOMPARE(document.features().size(), std::size_t{2});
  const Feature& counted = lastFeature(document);
  QCOMPARE(counted.type, std::string("made-up.count"));
  QCOMPARE(counted.name, std::string("Count"));
  QCOMPARE(counted.inputs, std::vector<FeatureId>{document.features()[0]->id});
  QVERIFY(!document.features()[0]->visible && counted.visible);
  QCOMPARE(openAny(app_, file("triangle.off")).document.features().size(), std::size_t{1});  // nobody opens meshes
}

namespace {

/// Every text in it that is an absolute path.
void collectAbsolute(const Value& value, std::vector<std::string>& found) {
  if (const auto* text = value.get_ptr<const std::string*>(); text && text->starts_with('/')) found.push_back(*text);
  if (value.is_structured())
    for (const Value& item : value) collectAbsolute(item, found);
}

}  // namespace

void AppTest::samplesNameNoFolderOfAMachine() {
  int documents = 0;
  std::size_t absolute = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::sample(""))) {
    std::vector<std::string> found;
    if (isDocument(entry.path()))
      collectAbsolute(Value::parse(toJson(openDocument(entry.path()).document)), found);
    else if (entry.path().extension() == ".json")
      collectAbsolute(Value::parse(readFile(entry.path())), found);
    else
      continue;
    ++documents;
    absolute += found.size();
    QVERIFY2(found.empty(), (entry.path().filename().string() + ": " + (found.empty() ? "" : found.front())).c_str());
  }
  QVERIFY(documents >= 20);
  fmt::print("figure sample_paths {}\n", absolute);
}

// What the programs that make the samples take in from a folder of their own.
void AppTest::whatIsTakenInKeepsItsNameAlone() {
  FeatureId id;
  const Document document = withImported(app_, Document(), file("triangle.off"), &id);
  QCOMPARE(document.at(id).parameters.at("file").at("path"), Value("triangle.off"));
  std::vector<std::string> found;
  collectAbsolute(Value::parse(toJson(document)), found);
  QVERIFY(found.empty());
}

void AppTest::resourcesAreFound() {
  QVERIFY(std::filesystem::exists(resourceFolder() / "manual/command-line.md"));
  qputenv("BLOSSOM_RESOURCES", folder_->path().toUtf8());
  QCOMPARE(QString::fromStdString(resourceFolder().string()), folder_->path());
  qunsetenv("BLOSSOM_RESOURCES");
}

BLOSSOM_TEST(AppTest)
#include "app_test.moc"
