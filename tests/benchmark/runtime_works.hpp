// The calls that are timed, each on the input of its hand.
#pragma once

#include <vector>

#include "fingertip_ik_peer.hpp"
#include "hand_case.hpp"
#include "kdl_peer.hpp"
#include "measurement.hpp"
#include "slsqp_peer.hpp"

namespace uhas::benchmark {

/// Single solves of `set` with the action's numbers as Real.
template <class Real>
Work solve_work(std::string name, const HandProfile& profile, const std::vector<double>& actions, int passes = 1);

/// Everything of the runtime library: solves, fingertips, observations, encoding; batches of `batch` hands.
std::vector<Work> runtime_works(const HandCase& hand, std::size_t batch);

/// The peers, which follow `hand.trajectory` from answer to answer. A peer's answers stay in `q`.
struct Peers {
  KdlPeer kdl;
  SlsqpPeer slsqp, slsqp_as_shipped;
  FingertipIkPeer fingertip_ik;
  std::vector<double> q_lma, q_slsqp, q_slsqp_as_shipped, q_fingertip_ik;  ///< [joints] last answers

  explicit Peers(const HandCase& hand);
};

std::vector<Work> peer_works(const HandCase& hand, Peers& peers);

}  // namespace uhas::benchmark
