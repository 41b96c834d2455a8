#include <ostream>

#include "report.hpp"
#include "text/numbers.hpp"
#include "text/table.hpp"

namespace uhas::benchmark {
namespace {

using tools::Align;
using tools::fixed;
using tools::Table;

constexpr const char* kForwardKinematics = "fingertips, double";

std::string nanoseconds(double value) { return fixed(value, value < 100 ? 1 : 0); }

std::string microseconds(double ns) {
  const double us = ns / 1000;
  return fixed(us, us < 1 ? 3 : us < 100 ? 2 : 0);
}

std::string number(double value) { return fixed(value, value < 10 ? 2 : value < 100 ? 1 : 0); }

void print_hand(const HandMeasurement& hand, std::ostream& out) {
  out << '\n'
      << hand.hand << ": " << hand.fingers << " fingers, " << hand.joints << " joints (" << hand.independent_joints
      << " independent), " << hand.stored_points << " points (the solver uses " << hand.solver_points << ")\n";
  Table works({{"work"},
               {"hands a sample", Align::right},
               {"median, ns a hand", Align::right},
               {"p99", Align::right},
               {"worst", Align::right},
               {"/ forward kinematics", Align::right}});
  for (const Measured& measured : hand.works)
    works.add_row({measured.work, std::to_string(measured.hands), nanoseconds(measured.summary.median),
                   nanoseconds(measured.summary.p99), nanoseconds(measured.summary.worst),
                   number(measured.summary.median / hand.median(kForwardKinematics))});
  works.print(out);

  Table tails({{"single calls, timed one by one"},
               {"median, ns", Align::right},
               {"p99", Align::right},
               {"worst", Align::right},
               {"p99 / median", Align::right}});
  const auto add = [&](const char* name, const Summary& summary) {
    tails.add_row({name, nanoseconds(summary.median), nanoseconds(summary.p99), nanoseconds(summary.worst),
                   number(summary.p99 / summary.median)});
  };
  add("solve, gentle", hand.gentle_tail.call);
  add("solve, any", hand.any_tail.call);
  add("encode, any", hand.encode_tail.call);
  add("the clock and the loop", hand.any_tail.clock);
  tails.print(out);

  Table peers({{"peer"}, {"tips within 1 mm", Align::right}, {"hands within limits", Align::right}});
  for (const PeerAnswers& peer : hand.peers)
    peers.add_row({peer.peer, fixed(100 * peer.reached, 1) + " %", fixed(100 * peer.within_limits, 1) + " %"});
  peers.print(out);

  Table sizes({{"object"}, {"sizeof", Align::right}, {"heap, bytes", Align::right}});
  for (const ObjectSize& object : hand.sizes)
    sizes.add_row({object.object, std::to_string(object.size_of), std::to_string(object.heap)});
  sizes.print(out);
}

}  // namespace

void print_tables(const RuntimeReport& report, std::ostream& out) {
  print_machine(report.machine, out);
  for (const HandMeasurement& hand : report.hands) print_hand(hand, out);

  out << "\nSolves of " << report.growth.hand << " as its stored points grow\n";
  Table growth({{"stored", Align::right}, {"used by the solver", Align::right}, {"median, ns", Align::right}});
  for (const PointGrowth::Row& row : report.growth.rows)
    growth.add_row(
        {std::to_string(row.stored_points), std::to_string(row.solver_points), nanoseconds(row.solve.median)});
  growth.print(out);

  out << '\n';
  print_table(report.judgements, out);
}

void print_markdown(const RuntimeReport& report, std::ostream& out) {
  print_machine(report.machine, out);
  out << '\n';
  std::vector<std::string> header{"µs a hand, median"};
  for (const HandMeasurement& hand : report.hands) header.push_back(hand.hand);
  print_markdown_header(header, out);
  for (const Measured& work : report.hands.front().works) {
    std::vector<std::string> row{work.work};
    for (const HandMeasurement& hand : report.hands) row.push_back(microseconds(hand.median(work.work)));
    print_markdown_row(row, out);
  }
  out << '\n';
  print_markdown(report.judgements, out);
}

}  // namespace uhas::benchmark
