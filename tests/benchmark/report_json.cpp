#include "report.hpp"

namespace uhas::benchmark {
namespace {

Json to_json(const Summary& summary) {
  return {{"median_ns", summary.median}, {"p99_ns", summary.p99}, {"worst_ns", summary.worst}};
}

Json to_json(const Tail& tail) { return {{"call", to_json(tail.call)}, {"clock", to_json(tail.clock)}}; }

Json to_json(const HandMeasurement& hand) {
  Json works = Json::array(), peers = Json::array(), sizes = Json::array();
  for (const Measured& measured : hand.works) {
    Json work = {{"work", measured.work}, {"hands_in_a_sample", measured.hands}};
    work.update(to_json(measured.summary));
    works.push_back(work);
  }
  for (const PeerAnswers& peer : hand.peers)
    peers.push_back({{"peer", peer.peer}, {"reached", peer.reached}, {"within_limits", peer.within_limits}});
  for (const ObjectSize& object : hand.sizes)
    sizes.push_back({{"object", object.object}, {"sizeof", object.size_of}, {"heap_bytes", object.heap}});
  return {{"hand", hand.hand},
          {"fingers", hand.fingers},
          {"joints", hand.joints},
          {"independent_joints", hand.independent_joints},
          {"stored_points", hand.stored_points},
          {"solver_points", hand.solver_points},
          {"works", works},
          {"peers", peers},
          {"single_calls",
           {{"gentle", to_json(hand.gentle_tail)},
            {"any", to_json(hand.any_tail)},
            {"encode, any", to_json(hand.encode_tail)}}},
          {"sizes", sizes}};
}

Json to_json(const PointGrowth& growth) {
  Json rows = Json::array();
  for (const PointGrowth::Row& row : growth.rows)
    rows.push_back(
        {{"stored_points", row.stored_points}, {"solver_points", row.solver_points}, {"solve", to_json(row.solve)}});
  return {{"hand", growth.hand}, {"profiles", rows}};
}

template <class Items>
Json to_list(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

}  // namespace

Json to_json(const RuntimeReport& report) {
  Json document = new_document("uhas-runtime-benchmark");
  document["machine"] = to_json(report.machine);
  document["settings"] = {{"seed", report.seed},
                          {"rounds", report.settings.rounds},
                          {"single_solves", report.settings.tail_calls},
                          {"runs_of_single_solves", report.settings.tail_runs},
                          {"batch", report.settings.batch}};
  document["hands"] = to_list(report.hands);
  document["point_growth"] = to_json(report.growth);
  document["requirements"] = to_json(report.judgements);
  return document;
}

}  // namespace uhas::benchmark
