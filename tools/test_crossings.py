# SPDX-License-Identifier: Apache-2.0
"""Edges and nodes that go through a warped facet, whose surface z = 4 (x - 1/2) (y - 1/2) is 1 above and below its corners' mean."""
import unittest

import numpy as np

import crossings

FACETS = np.array([(0, 1, 2, 3), (4, 5, 6, 6)])
CORNERS = [(0.0, 0.0, 1.0), (1.0, 0.0, -1.0), (1.0, 1.0, 1.0), (0.0, 1.0, -1.0)]


def edge_at(x, y, low, high):
    """The facet and a sliver that has the edge from (x, y, low) to (x, y, high)."""
    points = [*CORNERS, (x, y, low), (x, y, high), (x + 1e-4, y, high + 1.0)]
    return np.array(points), FACETS


class Crossings(unittest.TestCase):
    def count(self, *edge):
        edges, _ = crossings.crossings(*edge_at(*edge))
        return sum(edge.tolist() == [4, 5] for edge in edges)

    def test_the_surface_is_bilinear(self):
        # At (0.25, 0.75) it is at -0.25, where the two triangles are at 0 or -1; at (0.25, 0.25) at 0.25.
        self.assertEqual([self.count(0.25, 0.75, low, low + 9.0) for low in (-0.26, -0.24)], [1, 0])
        self.assertEqual([self.count(0.25, 0.25, low, low + 9.0) for low in (0.24, 0.26)], [1, 0])

    def test_beside_the_facet_nothing_crosses(self):
        self.assertEqual([self.count(x, 0.5, -9.0, 9.0) for x in (-0.01, 0.01, 0.99, 1.01)], [0, 1, 1, 0])

    def test_an_edge_of_the_same_node_is_left_out(self):
        # Along the diagonal the surface is at z = (2 t - 1)^2: the edge from its first corner meets it again at t = 3/4.
        points = np.array([*CORNERS, (1.0, 1.0, 0.0), (1.001, 1.0, 0.0)])
        self.assertEqual(len(crossings.crossings(points, np.array([(0, 1, 2, 3), (0, 4, 5, 5)]))[0]), 0)
        self.assertEqual(self.count(0.75, 0.75, 0.2, 0.3), 1)

    def test_triangles(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0.4, 0.4, -1), (0.4, 0.4, 1), (0.401, 0.4, 2), (0.6, 0.6, -1), (0.6, 0.6, 1), (0.601, 0.6, 2)], float)
        facets = np.array([(0, 1, 2, 2), (3, 4, 5, 5), (6, 7, 8, 8)])
        self.assertEqual(crossings.crossings(points, facets)[0].tolist(), [[3, 4], [3, 5]])

    def test_many_pairs_in_parts(self):
        low = np.random.default_rng(1).random((200, 3))
        high = low + 0.1
        expected = {(a, b) for a in range(200) for b in range(200) if np.all(low[a] <= high[b]) and np.all(low[b] <= high[a])}
        parts = list(crossings.near(low, high, low, high, most=500))
        self.assertGreater(len(parts), 5)
        found = [pair for a, b in parts for pair in zip(a.tolist(), b.tolist())]
        self.assertEqual(len(found), len(set(found)))
        self.assertEqual(set(found), expected)

    def test_a_node_passes(self):
        before, _ = edge_at(0.25, 0.75, -0.2, 9.0)
        for to, count in ((-0.24, 0), (-0.26, 1)):  # the surface is at -0.25 there
            after, _ = edge_at(0.25, 0.75, to, 9.0)
            self.assertEqual(len(crossings.passed(before, after, FACETS)), count)
        self.assertEqual(crossings.passed(before, after, FACETS).tolist(), [[4, 0, 1, 2, 3]])
        beside, _ = edge_at(1.25, 0.75, -9.0, 9.0)
        self.assertEqual(len(crossings.passed(before, beside, FACETS)), 0)


if __name__ == "__main__":
    unittest.main()
