"""Batches: thousands of pairs blended and measured, in processes or on a cluster, and never twice.

`jobs` finds what is to be done, `work` does one job, `processes` and `cluster` do many at once, `journal`
keeps what is finished, `summary` shows it.
"""
