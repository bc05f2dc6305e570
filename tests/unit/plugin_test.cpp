#include "feature/plugin.h"

#include <fstream>

#include "core/file.h"
#include "exchange/formats.h"
#include "support/support.h"

using namespace blossom;
namespace fs = std::filesystem;

namespace {

Value manifest() {
  return {{"id", "probe"},
          {"title", "Probe"},
          {"version", "1"},
          {"api", pluginApiVersion},
          {"summary", "To test."},
          {"compute", "probe.so"},
          {"features", {"probe.thing"}}};
}

void write(const fs::path& folder, const std::string& text) {
  fs::create_directories(folder);
  std::ofstream(folder / "plugin.json") << text;
}

/// A plugin folder with a copy of a module: a copy, so that every test loads its own.
void place(const fs::path& folder, const Value& json, const std::string& module = "probe.so") {
  write(folder, json.dump());
  fs::copy_file(test::buildFolder() / "tests/modules" / module, folder / "probe.so");
}

std::string brokenBy(const std::function<void(Value&)>& change) {
  const TemporaryFolder folder;
  Value json = manifest();
  change(json);
  write(folder.path(), json.dump());
  try {
    (void)readManifest(folder.path() / "plugin.json");
  } catch (const Error& e) {
    return e.code() == ErrorCode::PluginBroken ? e.message() : "another code";
  }
  return "nothing was thrown";
}

}  // namespace

class PluginTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { qunsetenv("BLOSSOM_PROBE"); }

  void aManifestIsRead() {
    const TemporaryFolder folder;
    write(folder.path(), manifest().dump());
    const PluginManifest read = readManifest(folder.path() / "plugin.json");
    QCOMPARE(read.id, std::string("probe"));
    QCOMPARE(read.compute, std::string("probe.so"));
    QCOMPARE(read.features, std::vector<std::string>{"probe.thing"});
    QCOMPARE(read.folder, folder.path());
    QVERIFY(read.manipulators.empty());
    QVERIFY(read.formats.empty());
    Value json = manifest();
    json["formats"] = {"probed", "more"};
    write(folder.path(), json.dump());
    QCOMPARE(readManifest(folder.path() / "plugin.json").formats, (std::vector<std::string>{"probed", "more"}));
  }

  void wrongManifestsSayWhichKey() {
    for (const char* key : {"id", "title", "version", "summary", "api", "compute", "features"})
      QVERIFY(brokenBy([&](Value& j) { j.erase(key); }).ends_with(std::string("the key \"") + key + "\" is missing."));
    QVERIFY(brokenBy([](Value& j) { j["title"] = 3; }).ends_with("\"title\" must be a text."));
    QVERIFY(brokenBy([](Value& j) { j["api"] = "1"; }).ends_with("\"api\" must be a whole number from 1."));
    QVERIFY(brokenBy([](Value& j) { j["compute"] = "../evil.so"; }).find("own folder") != std::string::npos);
    QVERIFY(brokenBy([](Value& j) { j["features"] = {"other.thing"}; }).find("such as \"probe.name\"") != std::string::npos);
    QVERIFY(brokenBy([](Value& j) { j["formats"] = "probed"; }).find("list of the ids of file formats") !=
            std::string::npos);
    QVERIFY(brokenBy([](Value& j) { j["formats"] = {1}; }).find("list of the ids of file formats") != std::string::npos);
    QVERIFY(brokenBy([](Value& j) { j["id"] = "Big Name"; }).find("lower-case") != std::string::npos);
    QVERIFY(brokenBy([](Value& j) { j = Value::array(); }).ends_with("it holds no object."));
    const TemporaryFolder folder;
    for (const std::string& rubbish : {std::string(), std::string("{"),
                                       std::string("\x7f"
                                                   "ELF\0\1",
                                                   6),
                                       std::string(100000, '[')}) {
      write(folder.path(), rubbish);
      VERIFY_ERROR(readManifest(folder.path() / "plugin.json"), ErrorCode::PluginBroken);
    }
    VERIFY_ERROR(readManifest(folder.path() / "nowhere/plugin.json"), ErrorCode::PluginBroken);
  }

  void aGoodPluginIsLoaded() {
    const TemporaryFolder folder;
    place(folder.path() / "probe", manifest());
    Registry registry;
    const auto plugins = loadPlugins(registry, {folder.path()});
    QCOMPARE(plugins.size(), std::size_t{1});
    QCOMPARE(plugins[0].problem, std::string());
    QCOMPARE(registry.at("thing")->evaluate(Value::object(), Inputs(), Progress::none()).shape.kind(), ShapeKind::Mesh);
  }

  void brokenPluginsAreSkippedAndLeaveNothing_data() {
    QTest::addColumn<QString>("module");
    QTest::addColumn<QString>("behaviour");
    QTest::addColumn<QString>("problem");
    QTest::newRow("undeclared") << "probe.so"
                                << "undeclared"
                                << "It registers the feature probe.more, which its plugin.json does not declare.";
    QTest::newRow("undeclared format") << "probe.so"
                                       << "a format"
                                       << "It registers the format probed, which its plugin.json does not declare.";
    QTest::newRow("double") << "probe.so"
                            << "double"
                            << "The feature type \"probe.thing\" exists already.";
    QTest::newRow("error") << "probe.so"
                           << "error"
                           << "The probe has no licence.";
    QTest::newRow("exception") << "probe.so"
                               << "exception"
                               << "It failed while registering its features: out of luck.";
    QTest::newRow("number") << "probe.so"
                            << "number"
                            << "It failed while registering its features.";
    QTest::newRow("wrong api")
        << "wrong_api.so"
        << "" << QString("Its module was made for plugin interface 999, and this Blossom has %1.").arg(pluginApiVersion);
    QTest::newRow("wrong layout") << "wrong_layout.so"
                                  << ""
                                  << "Its module was compiled with headers of another Blossom. Compile Probe again";
    QTest::newRow("no symbols") << "no_symbols.so"
                                << ""
                                << "Its module does not export blossomPluginApi";
    QTest::newRow("unresolved") << "unresolved.so"
                                << ""
                                << "Its module probe.so cannot be loaded";
  }

  void brokenPluginsAreSkippedAndLeaveNothing() {
    QFETCH(QString, module);
    QFETCH(QString, behaviour);
    QFETCH(QString, problem);
    qputenv("BLOSSOM_PROBE", behaviour.toUtf8());
    const TemporaryFolder folder;
    place(folder.path() / "probe", manifest(), module.toStdString());
    Registry registry;
    const auto plugins = loadPlugins(registry, {folder.path()});
    QCOMPARE(plugins.size(), std::size_t{1});
    QVERIFY2(plugins[0].problem.starts_with(problem.toStdString()), plugins[0].problem.c_str());
    QCOMPARE(plugins[0].manifest.id, std::string("probe"));
    QVERIFY(registry.types().empty());
  }

  void whatCannotBeLoadedIsReportedBeforeAnythingRuns() {
    const TemporaryFolder folder;
    Value future = manifest();
    future["api"] = 999;
    future.erase("summary");
    place(folder.path() / "a", future);
    Value lying = manifest();
    lying["features"] = {"probe.thing", "probe.promised"};
    place(folder.path() / "b", lying);
    write(folder.path() / "c", manifest().dump());
    write(folder.path() / "d", manifest().dump());
    std::ofstream(folder.path() / "d/probe.so") << "no library";
    write(folder.path() / "e", "rubbish");
    fs::create_directories(folder.path() / "no plugin");
    place(folder.path() / "f", manifest());
    Registry registry;
    const auto plugins = loadPlugins(registry, {folder.path(), "/no/such/folder"});
    QCOMPARE(plugins.size(), std::size_t{6});
    const auto starts = [&](std::size_t i, const char* text) { return plugins[i].problem.starts_with(text); };
    QVERIFY2(starts(0, "It was made for plugin interface 999"), plugins[0].problem.c_str());
    QVERIFY2(starts(1, "It does not register the feature probe.promised"), plugins[1].problem.c_str());
    QVERIFY2(starts(2, "Its module probe.so is missing."), plugins[2].problem.c_str());
    QVERIFY2(starts(3, "Its module probe.so cannot be loaded"), plugins[3].problem.c_str());
    QVERIFY2(plugins[4].problem.find("plugin.json") != std::string::npos, plugins[4].problem.c_str());
    QCOMPARE(plugins[4].manifest.id, std::string("e"));
    QCOMPARE(plugins[5].problem, std::string());
    QCOMPARE(registry.types().size(), std::size_t{1});
  }

  void theFirstOfEqualIdsWins() {
    const TemporaryFolder folder;
    place(folder.path() / "one/probe", manifest());
    place(folder.path() / "two/probe", manifest());
    Registry registry;
    const auto plugins = loadPlugins(registry, {folder.path() / "one", folder.path() / "two", folder.path() / "one/probe"});
    QCOMPARE(plugins.size(), std::size_t{1});
    QCOMPARE(plugins[0].manifest.folder, folder.path() / "one/probe");
  }

  void aFormatIsRegisteredBesideTheFeatures() {
    qputenv("BLOSSOM_PROBE", "a format");
    const TemporaryFolder folder;
    Value json = manifest();
    json["formats"] = {"probed"};
    place(folder.path() / "one/probe", json);
    Registry registry;
    const auto plugins = loadPlugins(registry, {folder.path() / "one"});
    QCOMPARE(plugins.at(0).problem, std::string());
    QVERIFY(registry.formats().find("probe"));
    // The same, promised but not registered; and with an extension that another format has.
    qunsetenv("BLOSSOM_PROBE");
    place(folder.path() / "two/probe", json);
    Registry second;
    QCOMPARE(loadPlugins(second, {folder.path() / "two"}).at(0).problem,
             std::string("It does not register the format probed, which its plugin.json declares."));
    QVERIFY(second.types().empty());
    qputenv("BLOSSOM_PROBE", "taken extension");
    place(folder.path() / "three/probe", json);
    Registry third;
    third.add(stepFormat());
    const std::string problem = loadPlugins(third, {folder.path() / "three"}).at(0).problem;
    QVERIFY2(problem.starts_with("The format \"probed\" has the extension \"step\", which belongs to step."),
             problem.c_str());
    QVERIFY(third.types().empty());
    QCOMPARE(third.formats().formats().size(), std::size_t{1});
  }

  void takenCommandsAreRefused() {
    const TemporaryFolder folder;
    place(folder.path() / "probe", manifest());
    Registry registry;
    FeatureType other;
    other.id = "other.thing";
    other.command = "thing";
    other.title = other.summary = "Other";
    other.evaluate = [](const Value&, const Inputs&, const Progress&) { return Evaluated{}; };
    registry.add(other);
    const auto plugins = loadPlugins(registry, {folder.path()});
    QCOMPARE(plugins[0].problem, std::string("The command \"thing\" of probe.thing is taken by other.thing."));
    QCOMPARE(registry.types().size(), std::size_t{1});
  }

  void theSearchPathFollowsTheEnvironment() {
    qputenv("BLOSSOM_PLUGIN_PATH", "/a:/b c::/d");
    const auto folders = pluginSearchPath();
    qunsetenv("BLOSSOM_PLUGIN_PATH");
    QCOMPARE(folders.at(0), fs::path("/a"));
    QCOMPARE(folders.at(1), fs::path("/b c"));
    QCOMPARE(folders.at(2), fs::path("/d"));
    QCOMPARE(fs::weakly_canonical(folders.at(3)), fs::weakly_canonical(test::buildFolder() / "lib/blossom/plugins"));
  }
};

BLOSSOM_TEST(PluginTest)
#include "plugin_test.moc"
