#include "uhas/report/lateral_tables_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace uhas {
namespace {

constexpr int kPlotsInRow = 3;
constexpr double kCellWidth = 300, kCellHeight = 240;               // px
constexpr double kLeft = 56, kRight = 16, kTop = 40, kBottom = 44;  // margins of a plot in its cell
constexpr double kDegrees = 180 / std::numbers::pi;
constexpr const char* kStyle =
    "text{font:12px "
    "sans-serif;fill:#222}.title{font-weight:bold}.tick{font-size:10px;fill:#555}.frame{fill:none;stroke:#999}"
    ".grid{stroke:#ddd}.curve{fill:none;stroke:#0b6e99;stroke-width:2}.neutral{fill:#d1495b}";

std::string number(double x, int decimals = 2) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, x);
  return text.data();
}

/// Text as XML holds it; names come from strangers' files.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

/// From values in [lower, upper] to pixels.
struct Axis {
  double lower, upper, first, last;

  double operator()(double x) const { return first + (x - lower) / (upper - lower) * (last - first); }

  /// Round numbers 1, 2 or 5 times a power of ten apart, some four to eight of them.
  std::vector<double> ticks() const {
    const double rough = (upper - lower) / 5, power = std::pow(10, std::floor(std::log10(rough)));
    const double step = power * (rough < 2 * power ? 1 : rough < 5 * power ? 2 : 5);
    std::vector<double> values;
    for (double k = std::ceil(lower / step); k * step <= upper; ++k) values.push_back(k * step + 0.0);  // -0 becomes 0
    return values;
  }
};

/// An axis that leaves `values` some room.
Axis axis_over(const std::vector<double>& values, double first, double last) {
  const auto [least, most] = std::ranges::minmax(values);
  const double room = std::max(0.05 * (most - least), 1e-6);
  return {least - room, most + room, first, last};
}

std::string text_at(double x, double y, const char* attributes, const std::string& text) {
  return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" " + attributes + ">" + escaped(text) + "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1) {
  return "<line class=\"grid\" x1=\"" + number(x0) + "\" y1=\"" + number(y0) + "\" x2=\"" + number(x1) + "\" y2=\"" +
         number(y1) + "\"/>\n";
}

struct Plot {
  const LateralTable* table;
  std::string title, note;
};

std::vector<Plot> plots_of(const HandProfile& profile) {
  const auto name = [&](const LateralTable& table) { return profile.tree.joints[table.joint].name; };
  std::vector<Plot> plots;
  std::vector<bool> drives(profile.lateral_tables.size(), false);
  for (const ProfileFinger& finger : profile.fingers) {
    if (finger.lateral_table < 0) continue;
    const LateralTable& table = profile.lateral_tables[finger.lateral_table];
    drives[finger.lateral_table] = true;
    plots.push_back({&table, finger.name + ": " + name(table),
                     "\u0394\u03b8 " + number(table.delta_theta_lower * kDegrees, 1) + "\u00b0 \u2026 " +
                         number(table.delta_theta_upper * kDegrees, 1) + "\u00b0"});
  }
  for (std::size_t i = 0; i < drives.size(); ++i)
    if (!drives[i]) plots.push_back({&profile.lateral_tables[i], name(profile.lateral_tables[i]), "stays at neutral"});
  return plots;
}

std::string draw(const Plot& plot, double x0, double y0) {
  std::vector<double> q, theta;
  for (const double value : plot.table->q) q.push_back(value * kDegrees);
  for (const double value : plot.table->theta) theta.push_back(value * kDegrees);
  const Axis x = axis_over(q, x0 + kLeft, x0 + kCellWidth - kRight),
             y = axis_over(theta, y0 + kCellHeight - kBottom, y0 + kTop);

  std::string text = text_at(x0 + kLeft, y0 + 18, "class=\"title\"", plot.title);
  text += text_at(x0 + kLeft, y0 + 33, "class=\"tick\"", plot.note);
  for (const double tick : x.ticks()) {
    text += line(x(tick), y.first, x(tick), y.last);
    text += text_at(x(tick), y.first + 13, "class=\"tick\" text-anchor=\"middle\"", number(tick, 0));
  }
  for (const double tick : y.ticks()) {
    text += line(x.first, y(tick), x.last, y(tick));
    text += text_at(x.first - 5, y(tick) + 4, "class=\"tick\" text-anchor=\"end\"", number(tick, 0));
  }
  text += "<rect class=\"frame\" x=\"" + number(x.first) + "\" y=\"" + number(y.last) + "\" width=\"" +
          number(x.last - x.first) + "\" height=\"" + number(y.first - y.last) +
          "\"/>\n<polyline class=\"curve\" points=\"";
  for (std::size_t i = 0; i < q.size(); ++i) text += (i ? " " : "") + number(x(q[i])) + "," + number(y(theta[i]));
  text += "\"/>\n<circle class=\"neutral\" r=\"4\" cx=\"" + number(x(plot.table->neutral * kDegrees)) + "\" cy=\"" +
          number(y(plot.table->theta_initial * kDegrees)) + "\"/>\n";
  text += text_at((x.first + x.last) / 2, y.first + 30, "text-anchor=\"middle\"", "joint, degrees");
  const std::string turn =
      "text-anchor=\"middle\" transform=\"rotate(-90 " + number(x0 + 16) + " " + number((y.first + y.last) / 2) + ")\"";
  return text + text_at(x0 + 16, (y.first + y.last) / 2, turn.c_str(), "azimuth \u03b8, degrees");
}

}  // namespace

std::string lateral_tables_svg(const HandProfile& profile) {
  const std::vector<Plot> plots = plots_of(profile);
  const int rows = std::max(1, (static_cast<int>(plots.size()) + kPlotsInRow - 1) / kPlotsInRow);
  const std::string size =
      "width=\"" + number(kPlotsInRow * kCellWidth, 0) + "\" height=\"" + number(rows * kCellHeight, 0) + "\"";
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">\n<title>Lateral tables of " +
                     escaped(profile.hand) + "</title>\n<style>" + kStyle + "</style>\n<rect " + size +
                     " fill=\"#fff\"/>\n";
  if (plots.empty()) text += text_at(kLeft, kTop, "", profile.hand + " has no lateral joint: delta theta is ignored");
  for (int i = 0; i < static_cast<int>(plots.size()); ++i)
    text += draw(plots[i], (i % kPlotsInRow) * kCellWidth, (i / kPlotsInRow) * kCellHeight);
  return text + "</svg>\n";
}

}  // namespace uhas
