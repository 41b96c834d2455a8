"""The self-test of a check: samples planted for it, of which it must catch the bad ones alone."""


def self_test(planted, catches):
    """Exit status. `planted` is [(sample, whether it is bad)]; `catches(sample)` says what the check has against it, if anything."""
    wrong = [f"{sample}: {'not caught' if bad else 'wrongly refused'}" for sample, bad in planted if bool(catches(sample)) != bad]
    print("\n".join(wrong) or f"{len(planted)} planted samples, each judged rightly")
    return 1 if wrong else 0
