#include <fmt/format.h>

#include <array>
#include <map>
#include <string_view>
#include <vector>

#include "drawn_plans.hpp"

namespace echoway::fuzz {
namespace {

class OsmDrawing {
 public:
  std::string draw(Reader& in) {
    for (int i = 0; i < 24; ++i) nodes_.push_back(take_spot(in));
    for (int i = 0; i < kMostFeatures && !in.empty(); ++i) feature(in, i + 1);
    std::string text = "<osm>\n";
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      text += fmt::format("<node id='{}' lat='{:.9f}' lon='{:.9f}'>{}</node>\n", i, nodes_[i].lat, nodes_[i].lon,
                          tags_[i]);
    }
    return text + features_ + "</osm>\n";
  }

 private:
  static std::string tags(Reader& in) {
    static constexpr std::array<std::string_view, 27> kTags{
        "indoor=room",     "indoor=area",      "indoor=corridor",  "indoor=wall",      "indoor=column",
        "level=0",         "level=1",          "level=0;1",        "level=0-2",        "level=0.5",
        "repeat_on=1",     "highway=steps",    "highway=elevator", "room=stairs",      "stairs=yes",
        "incline=down",    "door=yes",         "entrance=main",    "width=0.9",        "width=2",
        "amenity=toilets", "indoor=furniture", "building=yes",     "type=multipolygon", "name=A",
        "ref=1",           "level=-1"};
    std::string text;
    for (int left = in.byte() % 5; left >= 0; --left) {
      const std::string_view tag = one_of(in, kTags);
      const std::size_t equals = tag.find('=');
      text += fmt::format("<tag k='{}' v='{}'/>", tag.substr(0, equals), tag.substr(equals + 1));
    }
    return text;
  }

  void feature(Reader& in, int id) {
    const std::uint8_t what = in.byte();
    if (what < 64) {
      const std::size_t node = in.byte() % nodes_.size();
      tags_[node] += tags(in);
    } else if (what < 224) {
      std::string refs;
      const int first = in.byte() % 24;
      refs += fmt::format("<nd ref='{}'/>", first);
      for (int left = in.byte() % 8; left >= 0; --left) refs += fmt::format("<nd ref='{}'/>", in.byte() % 24);
      if (what < 184) refs += fmt::format("<nd ref='{}'/>", first);
      features_ += fmt::format("<way id='{}'>{}{}</way>\n", id, refs, tags(in));
    } else {
      static constexpr std::array<std::string_view, 3> kRoles{"outer", "inner", ""};
      std::string members;
      for (int left = in.byte() % 4; left >= 0; --left) {
        const int way = in.byte() % kMostFeatures;
        members += fmt::format("<member type='way' ref='{}' role='{}'/>", way, one_of(in, kRoles));
      }
      features_ += fmt::format("<relation id='{}'>{}<tag k='type' v='multipolygon'/>{}</relation>\n", id, members,
                               tags(in));
    }
  }

  std::vector<Spot> nodes_;
  std::map<std::size_t, std::string> tags_;
  std::string features_;
};

}  // namespace

Spot take_spot(Reader& in) {
  const std::uint8_t grid = in.byte();
  const std::uint8_t off = in.byte();
  const double jitter = off < 32 ? 0.01 * off : off < 40 ? 1e-4 * off : 0.0;
  const double x = 0.5 * (grid % 16) + jitter;
  const double y = 0.5 * (grid / 16) - 0.5 * jitter;
  return {8.0 + x / 75'900.0, 47.0 + y / 111'195.0};
}

std::string draw_osm(Reader& in) { return OsmDrawing().draw(in); }

}  // namespace echoway::fuzz
