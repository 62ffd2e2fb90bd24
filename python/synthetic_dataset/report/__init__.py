"""Makes a page about a dataset: what is in it, and what to look at. See docs/report.md."""
