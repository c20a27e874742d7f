#include "import/imported.hpp"
#include "support/process.hpp"

// Plans made to break an importer: each is refused with a reason that names the file, in bounded time and memory.
namespace echoway::import {
namespace {

using testing::HasSubstr;

class HostilePlan : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) { return folder_.write(name, text); }
  // A WRLD plan of one level with these features.
  std::filesystem::path wrld(const std::string& features) {
    write("main.json", R"({"name": "X", "levels": [{"name": "G", "z_order": 0, "filename": "g.geojson"}]})");
    write("g.geojson", R"({"type": "FeatureCollection", "features": [)" + features + "]}");
    return folder_.path();
  }
  static std::string wall(const std::string& coordinates) {
    return R"({"type": "Feature", "properties": {"id": 7, "type": "wall"}, "geometry": {"type": "Polygon", )"
           R"("coordinates": [[)" + coordinates + "]]}}";
  }

  static std::string refusal(SourceFormat format, const std::filesystem::path& source) {
    Report report;
    const auto imported = import_building(format, source, report);
    EXPECT_FALSE(imported);
    return imported ? "" : imported.error().to_string();
  }

  test::TemporaryFolder folder_;
};

TEST_F(HostilePlan, AZipBombIsRefusedBeforeItUnpacks) {
  EXPECT_THAT(refusal(SourceFormat::imdf, test_plan("hostile/bomb.zip")),
              testing::AllOf(HasSubstr("bomb.zip/level.geojson"), HasSubstr("larger than")));
}

TEST_F(HostilePlan, DeepNestingIsRefused) {
  EXPECT_THAT(refusal(SourceFormat::wrld, test_plan("hostile/deep")), HasSubstr("nested too deeply"));
  std::string xml = "<osm>";
  for (int i = 0; i < 10000; ++i) xml += "<a>";
  EXPECT_THAT(refusal(SourceFormat::osm, write("deep.osm", xml)), HasSubstr("nested too deeply"));
}

TEST_F(HostilePlan, NumbersThatAreNoCoordinatesAreRefusedWithTheirFeature) {
  EXPECT_THAT(refusal(SourceFormat::wrld, wrld(wall("[1e999, 0], [1, 1], [0, 1]"))), HasSubstr("g.geojson"));
  EXPECT_THAT(refusal(SourceFormat::wrld, wrld(wall("[null, 0], [1, 1], [0, 1]"))), HasSubstr("feature 7"));
  EXPECT_THAT(refusal(SourceFormat::wrld, wrld(wall("[250000, 0], [1, 1], [0, 1]"))),
              testing::AllOf(HasSubstr("feature 7"), HasSubstr("WGS 84")));
  EXPECT_THAT(refusal(SourceFormat::osm, write("nan.osm", "<osm>\n<node id='1' lat='nan' lon='0'/>\n</osm>")),
              HasSubstr("nan.osm:2: 'lat'"));
}

TEST_F(HostilePlan, BrokenTextIsRefusedWithItsLine) {
  wrld("");
  write("main.json", "{\n\"name\": \"X\",\n oops }");
  EXPECT_THAT(refusal(SourceFormat::wrld, folder_.path()), HasSubstr("main.json:3: "));
  EXPECT_THAT(refusal(SourceFormat::osm, write("cut.osm", "<osm>\n<node id='1'")), HasSubstr("cut.osm:2: "));
}

TEST_F(HostilePlan, TextInAnotherEncodingIsSaidToBe) {
  wrld("");
  write("main.json", "{\n\"name\": \"B\xFCro\", \"levels\": []}");
  EXPECT_THAT(refusal(SourceFormat::wrld, folder_.path()), HasSubstr("main.json:2: is not UTF-8 text"));
  write("main.json", std::string("\xFF\xFE{\0}\0", 6));
  EXPECT_THAT(refusal(SourceFormat::wrld, folder_.path()), HasSubstr("main.json:1: is not UTF-8 text"));
}

TEST_F(HostilePlan, EntitiesAreRefused) {
  EXPECT_THAT(refusal(SourceFormat::osm, write("laughs.osm", "<!DOCTYPE osm [<!ENTITY a 'ha'>]>\n<osm>&a;</osm>")),
              HasSubstr("laughs.osm:1: declares an entity"));
}

TEST_F(HostilePlan, ANameInAnArchiveIsNoPath) {
  wrld("");
  write("main.json", R"({"levels": [{"z_order": 0, "filename": "../../../../etc/passwd"}]})");
  EXPECT_THAT(refusal(SourceFormat::wrld, folder_.path()), HasSubstr("is missing"));
}

TEST_F(HostilePlan, AFeatureOnTheOtherSideOfTheEarthIsLeftOut) {
  const std::string square = R"({"type": "Feature", "properties": {"id": 1, "type": "building_outline"}, "geometry":
    {"type": "Polygon", "coordinates": [[[8.0, 47.0], [8.001, 47.0], [8.001, 47.001], [8.0, 47.001]]]}},)";
  const std::string room = R"({"type": "Feature", "properties": {"id": 2, "type": "unit", "name": "Only"}, "geometry":
    {"type": "Polygon", "coordinates": [[[8.0001, 47.0001], [8.0009, 47.0001], [8.0009, 47.0009], [8.0001, 47.0009]]]}
    },)";
  Report report;
  const auto imported = import_building(SourceFormat::wrld, wrld(square + room + wall("[0,0],[0.001,0],[0.001,0.001]")),
                                        report);
  ASSERT_TRUE(imported) << imported.error().to_string();
  EXPECT_THAT(report.items().front().to_string(), testing::AllOf(HasSubstr("feature 7"), HasSubstr("lies far")));
}

// A table of levels with a gap in it is written in decimals by many tools.
TEST_F(HostilePlan, AWholeNumberMayBeWrittenAsADecimal) {
  const std::string room = R"({"type": "Feature", "properties": {"id": 2, "type": "unit", "name": "Only"}, "geometry":
    {"type": "Polygon", "coordinates": [[[8.0001, 47.0001], [8.0002, 47.0001], [8.0002, 47.0002], [8.0001, 47.0002]]]}
    })";
  const auto import_level = [&](const std::string& number) {
    wrld(room);
    write("main.json",
          R"({"name": "X", "levels": [{"name": "G", "z_order": )" + number + R"(, "filename": "g.geojson"}]})");
    Report report;
    return import_building(SourceFormat::wrld, folder_.path(), report);
  };
  const auto imported = import_level("2.0");
  ASSERT_TRUE(imported) << imported.error().to_string();
  EXPECT_EQ(imported->building.rooms.front().level, 2);
  EXPECT_THAT(import_level("2.5").error().to_string(), HasSubstr("whole number"));
}

// Seven metres long and 0.035 mm wide: on the grid of all overlays nothing is left of it.
TEST_F(HostilePlan, StairsWithoutBreadthAreLeftOut) {
  const std::string room = R"({"type": "Feature", "properties": {"id": 2, "type": "unit", "name": "Only"}, "geometry":
    {"type": "Polygon", "coordinates": [[[8.0001, 47.0001], [8.0002, 47.0001], [8.0002, 47.0002], [8.0001, 47.0002]]]}
    },)";
  const std::string stairs = R"({"type": "Feature", "properties": {"id": 7, "type": "stairs"}, "geometry":
    {"type": "Polygon", "coordinates": [[[8.000104, 47.00015], [8.000196, 47.00015], [8.00015, 47.000150000315]]]}})";
  Report report;
  const auto imported = import_building(SourceFormat::wrld, wrld(room + stairs), report);
  ASSERT_TRUE(imported) << imported.error().to_string();
  EXPECT_THAT(report.items().front().to_string(),
              testing::AllOf(HasSubstr("feature 7"), HasSubstr("encloses nothing")));
}

TEST_F(HostilePlan, NothingThatEnclosesIsNoBuilding) {
  EXPECT_THAT(refusal(SourceFormat::wrld, wrld(wall("[8,47],[8.0001,47],[8.0001,47.00001],[8,47.00001]"))),
              HasSubstr("cannot become a building"));
  EXPECT_THAT(refusal(SourceFormat::wrld, wrld("")), HasSubstr("no feature with coordinates"));
  EXPECT_THAT(refusal(SourceFormat::osm, write("empty.osm", "<osm version='0.6'/>")),
              HasSubstr("Simple Indoor Tagging"));
  EXPECT_THAT(refusal(SourceFormat::imdf, folder_.path() / "absent"), HasSubstr("absent: no such folder"));
}

}  // namespace
}  // namespace echoway::import
