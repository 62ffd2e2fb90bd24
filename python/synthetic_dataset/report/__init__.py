"""Makes a page of a dataset: what is in it, what to look at. docs/report.md"""
