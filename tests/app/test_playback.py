from dataclasses import replace

import pytest

from app.playback import Pace, Playback, Repeat
from starskel.easing import Easing


def test_t_follows_the_clock() -> None:
    playback = Playback(duration=2).play(now=100)
    assert playback.playing
    assert playback.t(101) == 0.5


def test_once_stops_at_the_end_and_starts_again_from_the_beginning() -> None:
    playback = Playback(duration=2, repeat=Repeat.ONCE).play(0)
    assert not playback.ended(1.9)
    assert playback.ended(2)
    assert playback.t(7) == 1
    paused = playback.pause(7)
    assert paused.t(1000) == 1
    assert paused.play(10).t(11) == 0.5


def test_loop_jumps_back_to_the_start() -> None:
    playback = Playback(duration=1, repeat=Repeat.LOOP).play(0)
    assert playback.t(0.25) == 0.25
    assert playback.t(3.25) == 0.25


def test_ping_pong_turns_at_both_ends() -> None:
    playback = Playback(duration=1, repeat=Repeat.PING_PONG).play(0)
    assert [playback.t(now) for now in (0.25, 1.0, 1.25, 1.75, 2.25)] == [0.25, 1.0, 0.75, 0.25, 0.25]


@pytest.mark.parametrize("repeat", Repeat)
@pytest.mark.parametrize("t", [0.0, 0.3, 1.0])
def test_the_slider_reaches_every_t_in_every_mode(repeat: Repeat, t: float) -> None:
    assert Playback(repeat=repeat).seek(t, now=5).t(now=9) == t


@pytest.mark.parametrize("repeat", Repeat)
def test_pause_and_play_go_on_where_they_were(repeat: Repeat) -> None:
    running = Playback(duration=1, repeat=repeat).play(0)
    resumed = running.pause(0.75).play(50)
    assert resumed.t(50) == running.t(0.75)
    assert resumed.t(50.125) == pytest.approx(running.t(0.875))


def test_ping_pong_keeps_its_direction_over_a_pause() -> None:
    playback = Playback(duration=1).play(0).pause(1.25).play(10)
    assert playback.t(10.25) == 0.5


def test_changing_speed_or_mode_does_not_jump() -> None:
    playback = Playback(duration=1).play(0)
    assert playback.at_speed(4, now=0.5).t(0.5) == 0.5
    assert playback.at_speed(4, now=0.5).t(0.5625) == 0.75
    assert playback.repeating(Repeat.LOOP, now=1.25).t(1.25) == 0.75


def test_easing_bends_t_and_keeps_the_moment_when_it_changes() -> None:
    slow = Easing((0.5, 0.0), (1.0, 1.0))
    playback = Playback(duration=1, paces=(Pace(easing=slow),)).play(0)
    assert playback.t(0.25) < 0.15
    assert playback.t(1.75) == pytest.approx(playback.t(0.25))
    held = Playback().seek(0.3, 0).over((Pace(easing=slow),), 0, 0)
    assert held.t(5) == pytest.approx(0.3)


@pytest.mark.parametrize("easing", [Easing(), Easing((0.9, 0.1), (0.3, 0.8))])
def test_steps_go_to_the_frames_that_are_measured(easing: Easing) -> None:
    playback = Playback(paces=(Pace(easing=easing),)).seek(0.423, 0)
    assert playback.advance(1, 0).t(0) == pytest.approx(0.43)
    assert playback.advance(-1, 0).t(0) == pytest.approx(0.42)
    assert playback.advance(1, 0).advance(1, 0).t(0) == pytest.approx(0.44)
    assert playback.advance(-1, 0).advance(1, 0).t(0) == pytest.approx(0.43)
    assert playback.advance(200, 0).t(0) == 1
    assert playback.advance(-200, 0).t(0) == 0


def test_a_step_stops_what_is_playing() -> None:
    assert not Playback().play(0).advance(1, 0.5).playing


THREE = Playback(duration=1, paces=(Pace(1.0), Pace(2.0), Pace(1.0)))


def test_playing_runs_through_all_steps_each_as_long_as_it_is() -> None:
    playback = THREE.play(0)
    assert [playback.at(now) for now in (0.5, 2.0, 3.5)] == [(0, 0.5), (1, 0.5), (2, 0.5)]
    assert playback.at(4) == (2, 1)
    assert playback.at(4.5) == (2, 0.5)  # back and forth
    assert playback.at(7.5) == (0, 0.5)


def test_where_two_steps_meet_the_one_shown_is_kept() -> None:
    assert THREE.seek(1.0, 0).at(0) == (0, 1)
    assert THREE.into(1, 0.0, 0).at(0) == (1, 0)
    assert THREE.into(1, 1.0, 0).at(0) == (1, 1)
    assert THREE.into(2, 0.3, 0).seek(0.7, 0).at(0) == (2, pytest.approx(0.7))


@pytest.mark.parametrize("repeat", Repeat)
@pytest.mark.parametrize("step", range(3))
def test_every_moment_of_every_step_can_be_reached(repeat: Repeat, step: int) -> None:
    bent = Easing((0.9, 0.1), (0.3, 0.8))
    playback = replace(THREE, repeat=repeat, paces=tuple(Pace(k + 1, bent) for k in range(3)))
    for t in (0.0, 0.3, 1.0):
        assert playback.into(step, t, 0).at(0) == (step, pytest.approx(t))


def test_other_lengths_change_neither_t_nor_whether_it_plays() -> None:
    playback = THREE.play(0).into(1, 0.25, 0)
    longer = playback.over((Pace(1.0), Pace(8.0)), 1, 0)
    assert longer.at(0) == (1, pytest.approx(0.25))
    assert longer.at(2) == (1, pytest.approx(0.5))


def test_each_step_has_its_own_easing() -> None:
    bent = Easing((0.5, 0.0), (1.0, 1.0))
    playback = Playback(duration=1, paces=(Pace(), Pace(easing=bent))).play(0)
    assert playback.at(0.25) == (0, 0.25)
    assert playback.at(1.25) == (1, bent.t(0.25))
    assert playback.at(2.75) == (1, bent.t(0.25))  # on the way back


def test_going_frame_by_frame_leads_through_all_steps() -> None:
    end = THREE.into(0, 1.0, 0)
    assert end.advance(1, 0).at(0) == (1, pytest.approx(0.01))
    assert THREE.into(0, 0.99, 0).advance(1, 0).at(0) == (0, 1)
    assert THREE.into(1, 0.0, 0).advance(-1, 0).at(0) == (0, pytest.approx(0.99))
    assert THREE.into(1, 0.01, 0).advance(-1, 0).at(0) == (1, 0)
    assert THREE.into(2, 1.0, 0).advance(1, 0).at(0) == (2, 1)
    assert THREE.advance(-1, 0).at(0) == (0, 0)
