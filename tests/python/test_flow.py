"""The flow inside the balloon at any points."""

import numpy as np
import pytest


@pytest.fixture(scope="module")
def flow(case):
    return case.flow(stretch=1.1, rate=-0.1)


RADIUS, SPEED = 0.33, -0.03  # r and dr/dt [m/s] there


def test_the_liquid_follows_the_wall(flow):
    """Normal velocity dr/dt on the sphere but for the orifice, which is at negative z; seen from the centre."""
    theta = np.linspace(0.1, 2.5, 25)
    inside = RADIUS * (1 - 1e-9)
    fields = flow.fields(inside * np.sin(theta), inside * np.cos(theta))
    normal = fields["v_r"] * np.sin(theta) + fields["v_z"] * np.cos(theta)
    assert np.abs(normal - SPEED).max() < 1e-6 * abs(SPEED)
    assert flow.fields(0.0, -0.9 * RADIUS)["v_z"] < 10 * SPEED  # out through the orifice


def test_pressure_on_the_wall_is_that_of_its_table(flow):
    wall = flow.wall()
    pick = (wall["theta"] > 0.01) & (wall["theta"] < 3.0)
    theta = wall["theta"][pick]
    inside = RADIUS * (1 - 1e-12)
    found = flow.fields(inside * np.sin(theta), inside * np.cos(theta))["pressure"]
    assert np.abs(found - wall["pressure"][pick]).max() < 1e-6 * np.abs(wall["pressure"]).max()


def test_it_is_the_gradient_of_its_potential_and_has_no_divergence(flow):
    r, z = np.meshgrid([0.03, 0.1, 0.2], [-0.2, -0.05, 0.1, 0.25])
    h = 1e-4  # central differences: h^2/r^2 = 1e-5 of the flow near the axis, rounding 1e-16/h

    def at(dr, dz, name):
        return flow.fields(r + dr, z + dz)[name]

    here = flow.fields(r, z)
    size = np.abs(here["v_z"]).max()
    assert np.abs((at(h, 0, "potential") - at(-h, 0, "potential")) / (2 * h) - here["v_r"]).max() < 1e-4 * size
    assert np.abs((at(0, h, "potential") - at(0, -h, "potential")) / (2 * h) - here["v_z"]).max() < 1e-4 * size
    divergence = (((r + h) * at(h, 0, "v_r") - (r - h) * at(-h, 0, "v_r")) / r + at(0, h, "v_z") - at(0, -h, "v_z")) / (2 * h)
    assert np.abs(divergence).max() < 1e-4 * size / 0.03


def test_points_keep_their_shape(flow):
    assert flow.fields(np.zeros((3, 4)), np.zeros((3, 4)))["v_r"].shape == (3, 4)
    assert flow.fields(0.1, 0.1)["pressure"].shape == ()
